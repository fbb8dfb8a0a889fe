#include "pipeline/ledger.h"

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <chrono>
#include <cstring>

#include <fcntl.h>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/error.h"
#include "base/input_file.h"
#include "base/json_bytes.h"

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
  return json_text(json) + "\n";
}

LedgerEntry entry_of(const Json& json, const std::string& where) {
  if (json.at("v") != kLedgerVersion)
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

/// Opens what a run may append to. Neither a link nor a pipe or device without a reader holds us up.
Descriptor open_ledger(const std::filesystem::path& file, LedgerUse use) {
  const int how = use == LedgerUse::append ? O_RDWR | O_CREAT | O_APPEND : O_RDONLY;
  Descriptor descriptor(::open(file.c_str(), how | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, 0644));
  if (!descriptor && errno == ELOOP)
    throw Error("is a link; a ledger must be a file of its own", file.string());
  if (!descriptor && use == LedgerUse::read && errno == ENOENT) return descriptor;
  if (!descriptor) fail(file, use == LedgerUse::append ? "cannot be written" : "cannot be read");
  struct stat status {};
  if (::fstat(descriptor.number(), &status) != 0) fail(file, "cannot be read");
  if (!S_ISREG(status.st_mode)) throw Error("is not a regular file, as a ledger must be", file.string());
  if (std::uint64_t(status.st_size) > kLargestOwnFile)
    throw Error("is larger than any ledger of a run: " + bytes_text(std::uint64_t(status.st_size)),
                file.string());
  if (use == LedgerUse::append && status.st_nlink > 1)
    throw Error("has a second name (a hard link), under which it would change too; make it a copy of its own",
                file.string());
  return descriptor;
}

std::string read_all(const Descriptor& descriptor, const std::filesystem::path& file) {
  std::string text;
  std::string block(1 << 16, '\0');
  for (;;) {
    const ssize_t count = ::pread(descriptor.number(), block.data(), block.size(), off_t(text.size()));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail(file, "cannot be read");
    if (count == 0) return text;
    text.append(block, 0, std::size_t(count));
  }
}

/// Whether a run that was killed at its first line may have left this.
bool is_start_of_line(std::string_view text) {
  const std::string start = fmt::format("{{\"v\":{},\"id\":\"", kLedgerVersion);
  const std::size_t common = std::min(text.size(), start.size());
  return text.substr(0, common) == start.substr(0, common);
}

}  // namespace

std::string utc_now() {
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::chrono::system_clock::now()));
}

Ledger::Ledger(const std::filesystem::path& file, LedgerUse use) : file_(file) {
  if (use == LedgerUse::append) {
    std::error_code error;
    std::filesystem::create_directories(file.parent_path(), error);
    if (error) throw Error("cannot make the folder: " + error.message(), file.parent_path().string());
  }
  Descriptor descriptor = open_ledger(file, use);
  if (!descriptor) return;
  if (use == LedgerUse::append && ::flock(descriptor.number(), LOCK_EX | LOCK_NB) != 0)
    throw Error("another run is working in this folder", file.parent_path().string());
  const std::size_t whole = take_lines(read_all(descriptor, file));
  if (use == LedgerUse::read) return;
  if (::ftruncate(descriptor.number(), off_t(whole)) != 0) fail(file, "cannot be written");
  descriptor_ = std::move(descriptor);
}

/// Takes in all whole lines; returns the bytes that they have.
std::size_t Ledger::take_lines(const std::string& text) {
  const std::string_view all = text;
  std::size_t start = 0;
  for (std::size_t number = 1, end; (end = all.find('\n', start)) != all.npos; start = end + 1, ++number) {
    const std::string where = fmt::format("{}:{}", file_.string(), number);
    try {
      remember(entry_of(parse_json_text(all.substr(start, end - start)), where));
    } catch (const nlohmann::json::exception&) {
      throw Error("is not a line of a ledger; remove the file to begin anew", where);
    }
  }
  if (start == 0 && !is_start_of_line(all))
    throw Error("is not a ledger; remove the file to begin anew", file_.string());
  return start;
}

void Ledger::append(const LedgerEntry& entry) {
  assert(descriptor_);
  if (!write_all(descriptor_, line_of(entry))) fail(file_, "cannot be written");
  if (::fsync(descriptor_.number()) != 0) fail(file_, "cannot be synced");
  remember(entry);
}

void Ledger::remember(const LedgerEntry& entry) {
  last_[entry.id] = entry;
  if (entry.outcome == Outcome::ok) last_done_[entry.id] = entry;
}

}  // namespace lightbench
