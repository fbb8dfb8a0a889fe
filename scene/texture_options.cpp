#include "scene/texture_options.h"

#include <algorithm>
#include <array>
#include <optional>

#include <fmt/format.h>

#include "scene/text_scan.h"

namespace lightbench {
namespace {

enum class Argument {
  numbers,  ///< up to Option::most
  toggle,   ///< on or off
  word,
};

struct Option {
  std::string_view name;
  Argument argument;
  std::size_t most = 1;
  /// What the option says where it changes nothing: numbers, or a word. Empty: it never changes the picture,
  /// because nothing is filtered that it could tune, or because it is meant for other kinds of maps.
  std::string_view neutral = {};
};

constexpr std::array kOptions{
    Option{"-s", Argument::numbers, 3},
    Option{"-o", Argument::numbers, 3},
    Option{"-t", Argument::numbers, 3, "0 0 0"},
    Option{"-mm", Argument::numbers, 2, "0 1"},
    Option{"-clamp", Argument::toggle, 1, "off"},
    Option{"-type", Argument::word, 1, "-"},
    Option{"-imfchan", Argument::word, 1, "m"},
    Option{"-blendu", Argument::toggle},
    Option{"-blendv", Argument::toggle},
    Option{"-cc", Argument::toggle},
    Option{"-boost", Argument::numbers},
    Option{"-bm", Argument::numbers},
    Option{"-texres", Argument::word},
};

// No system has longer paths. A line may have millions of bytes, and as many options.
constexpr std::size_t kLongestName = 4096;

const Option* find_option(std::string_view word) {
  const std::string name = lower_case(word);
  const auto found =
      std::find_if(kOptions.begin(), kOptions.end(), [&](const Option& o) { return o.name == name; });
  return found == kOptions.end() ? nullptr : &*found;
}

// The words that an option may have, and the text after each of them.
struct Arguments {
  std::array<std::string_view, 3> words;
  std::array<std::string_view, 3> after;
  std::size_t count = 0;
};

bool fits(const Option& option, std::string_view word) {
  if (option.argument == Argument::numbers) return classify_number(word) != NumberKind::malformed;
  const std::string lowered = lower_case(word);
  return option.argument == Argument::word || lowered == "on" || lowered == "off";
}

Arguments take_arguments(const Option& option, std::string_view text) {
  Arguments arguments;
  while (arguments.count < option.most) {
    const std::string_view word = take_word(text);
    if (word.empty() || !fits(option, word)) break;
    arguments.words[arguments.count] = word;
    arguments.after[arguments.count++] = text;
  }
  return arguments;
}

bool is_neutral(const Option& option, const Arguments& arguments, std::size_t count) {
  std::string_view neutral = option.neutral;
  for (std::size_t i = 0; i < count; ++i) {
    const std::string_view word = take_word(neutral);
    const bool same = option.argument == Argument::numbers ? number_of(arguments.words[i]) == number_of(word)
                                                           : lower_case(arguments.words[i]) == word;
    if (!same) return false;
  }
  return true;
}

void apply(const Option& option, const Arguments& arguments, std::size_t count, TextureStatement& statement) {
  for (std::size_t i = 0; i < count && option.argument == Argument::numbers; ++i)
    if (classify_number(arguments.words[i]) == NumberKind::not_finite)
      statement.problem = fmt::format("{} has '{}', which is no finite number", option.name,
                                      arguments.words[i].substr(0, 40));
  for (std::size_t i = 0; i < std::min<std::size_t>(count, 2); ++i) {
    if (option.name == "-s") statement.placement.scale[int(i)] = number_of(arguments.words[i]);
    if (option.name == "-o") statement.placement.offset[int(i)] = number_of(arguments.words[i]);
  }
  if (option.neutral.empty() || is_neutral(option, arguments, count)) return;
  if (std::ranges::find(statement.unshown, option.name) == statement.unshown.end())
    statement.unshown.emplace_back(option.name);
}

class StatementReader {
 public:
  explicit StatementReader(const std::function<bool(const std::string&)>& is_file) : is_file_(is_file) {}

  TextureStatement run(std::string_view text) {
    text = take_options(text, true);
    if (names_file(text)) return named(statement_, text);
    if (other_) return *other_;
    // Neither a comment nor options belong behind the name, but files have them there.
    text = take_options_behind(stripped(without_comment(text)));
    return named(statement_, text);
  }

 private:
  static TextureStatement named(TextureStatement statement, std::string_view name) {
    statement.name = name;
    return statement;
  }

  bool names_file(std::string_view text) const {
    return !text.empty() && text.size() <= kLongestName && is_file_(std::string(text));
  }

  // Takes options off the front; what is left is the name.
  std::string_view take_options(std::string_view text, bool may_be_name) {
    for (text = stripped(text); !text.empty() && !(may_be_name && names_file(text));) {
      std::string_view rest = text;
      const Option* option = find_option(take_word(rest));
      if (!option) break;
      const Arguments arguments = take_arguments(*option, rest);
      if (may_be_name) look_for_shorter(*option, arguments, rest);
      apply(*option, arguments, arguments.count, statement_);
      text = stripped(arguments.count > 0 ? arguments.after[arguments.count - 1] : rest);
    }
    return text;
  }

  // The last arguments of an option may be the beginning of a name, such as "2 trees.png".
  void look_for_shorter(const Option& option, const Arguments& arguments, std::string_view rest) {
    for (std::size_t count = arguments.count; count-- > 0 && !other_;) {
      const std::string_view name = stripped(count > 0 ? arguments.after[count - 1] : rest);
      if (!names_file(name)) continue;
      other_ = named(statement_, name);
      apply(option, arguments, count, *other_);
    }
  }

  std::string_view take_options_behind(std::string_view text) {
    std::string_view rest = text;
    for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest)) {
      const std::size_t start = std::size_t(word.data() - text.data());
      if (start == 0 || !find_option(word) || !names_file(stripped(text.substr(0, start)))) continue;
      take_options(text.substr(start), false);
      return stripped(text.substr(0, start));
    }
    return text;
  }

  const std::function<bool(const std::string&)>& is_file_;
  TextureStatement statement_;
  std::optional<TextureStatement> other_;  // a shorter reading that names a file
};

}  // namespace

TextureStatement read_texture_statement(std::string_view text,
                                        const std::function<bool(const std::string&)>& is_file) {
  return StatementReader(is_file).run(text);
}

}  // namespace lightbench
