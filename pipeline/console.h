#pragma once

#include <string_view>

/// What commands tell people. Names and messages come from files and other programs, so text is cleaned first
/// (clean_utf8): nothing of them can steer a terminal. Data for programs is printed as it is, not by these.
namespace lightbench {

/// A line, or several, on standard output; a line feed that is missing at the end is added.
void say(std::string_view text);
/// Says it on the error stream.
void say_aside(std::string_view text);
/// "warning: ..." on the error stream.
void warn(std::string_view text);

}  // namespace lightbench
