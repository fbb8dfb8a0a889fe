#pragma once

#include <string>

#include <CLI/App.hpp>

/// What is wrong with a command line, with the nearest name that there is. CLI11 would only say that
/// something is missing or was not expected.
namespace lightbench {

/// Throws Error where a word stands in the place of a command and is none. To be called before parsing.
void check_commands(const CLI::App& app, int argc, const char* const* argv);

/// Throws Error for an option, or else a word, that the parsed command has no place for. To be called when
/// parsing has failed.
void check_leftovers(const CLI::App& app);

/// The check of an option that is one of some names.
CLI::Validator one_of(std::vector<std::string> names);

}  // namespace lightbench
