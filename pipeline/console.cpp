#include "pipeline/console.h"

#include <cstdio>
#include <string>

#include "base/utf8.h"

namespace lightbench {

namespace {

void print(std::FILE* stream, std::string_view text) {
  const std::string clean = clean_utf8(text);
  std::fwrite(clean.data(), 1, clean.size(), stream);
  if (!clean.ends_with('\n')) std::fputc('\n', stream);
}

}  // namespace

void say(std::string_view text) {
  print(stdout, text);
}

void say_aside(std::string_view text) {
  print(stderr, text);
}

void warn(std::string_view text) {
  say_aside("warning: " + std::string(text));
}

}  // namespace lightbench
