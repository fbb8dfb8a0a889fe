#include "pipeline/ledger.h"

#include <cassert>
#include <cerrno>
#include <chrono>
#include <cstring>

#include <fcntl.h>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sys/file.h>
#include <unistd.h>

#include "base/error.h"
#include "base/files.h"

namespace lightbench {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kLedgerVersion = 1;

std::string line_of(const LedgerEntry& entry) {
  Json json = {{"v", kLedgerVersion}, {"id", entry.id}, {"key", entry.key}, {"ended", entry.ended}};
  json["outcome"] = entry.outcome == Outcome::ok ? "ok" : "failed";
  if (!entry.error.empty()) json["error"] = entry.error;
  json["contended"] = entry.contended;
  json["parts"] = Json::array();
  for (const auto& [name, value] : entry.key_parts) json["parts"].push_back({name, value});
  if (entry.outcome == Outcome::ok) json["result"] = to_json(entry.result);
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

LedgerEntry entry_of(const Json& json, const std::string& where) {
  if (json.at("v").get<int>() != kLedgerVersion)
    throw Error("was written by another version of lightbench; choose another folder or remove it", where);
  LedgerEntry entry;
  entry.id = json.at("id").get<std::string>();
  entry.key = json.at("key").get<std::string>();
  entry.ended = json.at("ended").get<std::string>();
  entry.outcome = json.at("outcome").get<std::string>() == "ok" ? Outcome::ok : Outcome::failed;
  entry.error = json.value("error", "");
  entry.contended = json.at("contended").get<bool>();
  for (const auto& part : json.at("parts"))
    entry.key_parts.emplace_back(part.at(0).get<std::string>(), part.at(1).get<std::string>());
  if (entry.outcome == Outcome::ok) entry.result = task_result_from_json(json.at("result"), where);
  return entry;
}

[[noreturn]] void fail(const std::filesystem::path& file, const char* what) {
  throw Error(fmt::format("{}: {}", what, std::strerror(errno)), file.string());
}

}  // namespace

std::string utc_now() {
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::chrono::system_clock::now()));
}

Ledger::Ledger(const std::filesystem::path& file, LedgerUse use) : file_(file) {
  std::error_code error;
  if (use == LedgerUse::read) {
    if (std::filesystem::exists(file, error)) read();
    return;
  }
  std::filesystem::create_directories(file.parent_path(), error);
  if (error) throw Error("cannot make the folder: " + error.message(), file.parent_path().string());
  descriptor_ = open(file.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
  if (descriptor_ < 0) fail(file, "cannot be written");
  try {
    if (flock(descriptor_, LOCK_EX | LOCK_NB) != 0)
      throw Error("another run is working in this folder", file.parent_path().string());
    if (ftruncate(descriptor_, off_t(read())) != 0) fail(file, "cannot be written");
  } catch (...) {
    close(descriptor_);
    throw;
  }
}

Ledger::~Ledger() {
  if (descriptor_ >= 0) close(descriptor_);
}

/// Takes in all whole lines; returns the bytes that they have.
std::size_t Ledger::read() {
  const std::string text = read_file(file_);
  std::size_t start = 0;
  for (std::size_t number = 1;; ++number) {
    const std::size_t end = text.find('\n', start);
    if (end == std::string::npos) return start;
    const std::string where = fmt::format("{}:{}", file_.string(), number);
    try {
      remember(entry_of(Json::parse(text.substr(start, end - start)), where));
    } catch (const nlohmann::json::exception&) {
      throw Error("is not a line of a ledger; remove the file to begin anew", where);
    }
    start = end + 1;
  }
}

void Ledger::append(const LedgerEntry& entry) {
  assert(descriptor_ >= 0);
  const std::string line = line_of(entry);
  std::size_t written = 0;
  while (written < line.size()) {
    const ssize_t count = write(descriptor_, line.data() + written, line.size() - written);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail(file_, "cannot be written");
    written += std::size_t(count);
  }
  if (fsync(descriptor_) != 0) fail(file_, "cannot be synced");
  remember(entry);
}

void Ledger::remember(const LedgerEntry& entry) {
  last_[entry.id] = entry;
  if (entry.outcome == Outcome::ok) last_done_[entry.id] = entry;
}

}  // namespace lightbench
