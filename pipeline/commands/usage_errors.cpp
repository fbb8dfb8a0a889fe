#include "pipeline/commands/usage_errors.h"

#include <algorithm>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "base/error.h"
#include "base/text.h"

namespace lightbench {
namespace {

std::vector<const CLI::App*> commands_of(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

/// "lightbench", "lightbench scene check".
std::string full_name(const CLI::App& app) {
  const CLI::App* parent = app.get_parent();
  return parent ? full_name(*parent) + " " + app.get_name() : app.get_name();
}

/// The command that was asked for, as far as the command line was understood.
const CLI::App& parsed_command(const CLI::App& app) {
  const auto parsed = app.get_subcommands();
  return parsed.empty() ? app : parsed_command(*parsed.front());
}

/// The long names: a wrong letter is as far from all other letters.
std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

bool is_option(const std::string& word) {
  return word.size() > 1 && word.front() == '-';
}

}  // namespace

void check_commands(const CLI::App& app, int argc, const char* const* argv) {
  const CLI::App* level = &app;
  for (int i = 1; i < argc && argv[i][0] != '-'; ++i) {
    const std::vector<const CLI::App*> commands = commands_of(*level);
    if (commands.empty()) return;
    const std::string word = argv[i];
    const auto found = std::ranges::find(commands, word, [](const CLI::App* c) { return c->get_name(); });
    if (found == commands.end()) {
      std::vector<std::string> names;
      for (const CLI::App* command : commands) names.push_back(command->get_name());
      throw Error(fmt::format("there is no command '{}'{}; see {} --help", word, did_you_mean(word, names),
                              full_name(*level)));
    }
    level = *found;
  }
}

void check_leftovers(const CLI::App& app) {
  const std::vector<std::string> words = app.remaining(true);
  if (words.empty()) return;
  const CLI::App& command = parsed_command(app);
  const std::string see = "; see " + full_name(command) + " --help";
  const auto option = std::ranges::find_if(words, is_option);
  if (option == words.end()) throw Error(fmt::format("'{}' is one word too many{}", words.front(), see));
  const std::string name = option->substr(0, option->find('='));
  const std::vector<std::string> names = option_names(command);
  if (std::ranges::find(names, name) != names.end())
    throw Error(
        fmt::format("'{}' must stand behind the command: {} {}{}", name, full_name(command), name, see));
  throw Error(fmt::format("there is no option '{}'{}{}", name, did_you_mean(name, names), see));
}

CLI::Validator one_of(std::vector<std::string> names) {
  const std::string listed = join(names, ",");
  const auto check = [names = std::move(names)](const std::string& text) {
    if (std::ranges::find(names, text) != names.end()) return std::string();
    return fmt::format("must be one of {}, not '{}'{}", join(names, ", "), text, did_you_mean(text, names));
  };
  return {check, "{" + listed + "}", "name"};
}

}  // namespace lightbench
