#include "scene/mtl_loader.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <set>
#include <sstream>
#include <utility>

#include <fmt/format.h>
#include <strings.h>
#include <tiny_obj_loader.h>

#include "base/files.h"
#include "scene/text_scan.h"

namespace lightbench {
namespace {

enum class Use {
  new_material,
  color,  ///< one or three numbers, not negative
  number,
  texture,
  ignored,  ///< means nothing in lightbench's lighting model
  unshown,  ///< would change the picture, and is not shown
};

struct Keyword {
  std::string_view name;  ///< as the parser knows it; files write it in any case
  Use use;
};

constexpr std::array kKeywords{
    Keyword{"newmtl", Use::new_material},
    Keyword{"Kd", Use::color},
    Keyword{"Ks", Use::color},
    Keyword{"Ke", Use::color},
    Keyword{"Ns", Use::number},
    Keyword{"d", Use::number},
    Keyword{"Tr", Use::number},
    Keyword{"map_Kd", Use::texture},
    Keyword{"map_d", Use::texture},
    Keyword{"illum", Use::ignored},
    Keyword{"Ka", Use::ignored},
    Keyword{"map_Ka", Use::ignored},
    Keyword{"Ni", Use::ignored},
    Keyword{"Tf", Use::ignored},
    Keyword{"Kt", Use::ignored},
    Keyword{"sharpness", Use::ignored},
    Keyword{"map_aat", Use::ignored},
    Keyword{"map_Bump", Use::unshown},
    Keyword{"bump", Use::unshown},
    Keyword{"norm", Use::unshown},
    Keyword{"map_Ks", Use::unshown},
    Keyword{"map_Ns", Use::unshown},
    Keyword{"map_Ke", Use::unshown},
    Keyword{"disp", Use::unshown},
    Keyword{"map_disp", Use::unshown},
    Keyword{"refl", Use::unshown},
    Keyword{"map_refl", Use::unshown},
    Keyword{"decal", Use::unshown},
    Keyword{"Pr", Use::unshown},
    Keyword{"Pm", Use::unshown},
    Keyword{"Ps", Use::unshown},
    Keyword{"Pc", Use::unshown},
    Keyword{"Pcr", Use::unshown},
    Keyword{"aniso", Use::ignored},
    Keyword{"anisor", Use::ignored},
    Keyword{"map_Pr", Use::unshown},
    Keyword{"map_Pm", Use::unshown},
    Keyword{"map_Ps", Use::unshown},
    Keyword{"map_Tr", Use::unshown},
    Keyword{"map_opacity", Use::unshown},
};

const Keyword* find_keyword(std::string_view word) {
  const auto found = std::find_if(kKeywords.begin(), kKeywords.end(), [&](const Keyword& k) {
    return k.name.size() == word.size() && ::strncasecmp(k.name.data(), word.data(), word.size()) == 0;
  });
  return found == kKeywords.end() ? nullptr : &*found;
}

// What the text of a material says beyond what the parser keeps of it.
struct Facts {
  std::size_t line = 0;
  std::map<std::string_view, std::size_t> lines;  // of its last statement of each keyword
  std::set<std::string_view> grey;                // colours given as one number
  std::vector<std::string> unshown;
};

class MtlChecker {
 public:
  MtlChecker(std::string& text, const std::filesystem::path& file, ProblemList& problems, std::size_t most)
      : text_(text),
        file_(file),
        most_(most),
        bad_(problems, Problem::Severity::error, "malformed statements", file.string()),
        unknown_(problems, Problem::Severity::warning, "statements that mean nothing", file.string()) {}

  std::vector<Facts> run() {
    LineScanner lines(text_);
    while (const auto line = lines.next()) {
      line_ = lines.line();
      truncated_ = !lines.ended_by_newline();
      check_line(*line);
    }
    return std::move(facts_);
  }

 private:
  void check_line(std::string_view line) {
    std::string_view rest = line;
    const std::string_view word = take_word(rest);
    if (word.empty() || word[0] == '#') return;
    const Keyword* keyword = find_keyword(word);
    if (!keyword) return unknown_.add(fmt::format("unknown statement '{}'", word.substr(0, 40)), here());
    std::copy(keyword->name.begin(), keyword->name.end(), text_.begin() + std::ptrdiff_t(position(word)));
    if (keyword->use == Use::new_material) return begin_material(word, stripped(rest));
    if (facts_.empty())
      return unknown_.add(fmt::format("'{}' before the first newmtl is of no material", keyword->name),
                          here());
    check_statement(*keyword, stripped(rest));
  }

  void begin_material(std::string_view word, std::string_view name) {
    if (name.empty()) {
      bad_.add(fmt::format("newmtl without a name{}", cut()), here());
      text_[position(word)] = '#';
      return;
    }
    if (facts_.size() == most_)
      throw Error(fmt::format("the file has more than {} materials", most_), here());
    facts_.emplace_back().line = line_;
  }

  void check_statement(const Keyword& keyword, std::string_view rest) {
    Facts& facts = facts_.back();
    facts.lines[keyword.name] = line_;
    if (keyword.use == Use::color) check_color(keyword, rest, facts);
    if (keyword.use == Use::number) check_number(keyword, rest);
    if (keyword.use == Use::texture && rest.empty())
      bad_.add(fmt::format("{} without a file{}", keyword.name, cut()), here());
    if (keyword.use == Use::unshown) facts.unshown.emplace_back(keyword.name);
    if (keyword.name == "illum" && number_of(rest) >= 3)
      facts.unshown.emplace_back("mirror or glass (illum 3 and above)");
  }

  bool is_usable(std::string_view word, std::string_view keyword) {
    if (classify_number(word) == NumberKind::finite) return true;
    bad_.add(fmt::format("{} has '{}', which is no finite number{}", keyword, word.substr(0, 40), cut()),
             here());
    return false;
  }

  void check_color(const Keyword& keyword, std::string_view rest, Facts& facts) {
    std::size_t count = 0;
    for (std::string_view word = take_word(rest); !word.empty() && word[0] != '#'; word = take_word(rest)) {
      if (word == "spectral" || word == "xyz")
        return bad_.add(fmt::format("{} is given as '{}'; only RGB colours are read", keyword.name, word),
                        here());
      if (!is_usable(word, keyword.name)) return;
      if (number_of(word) < 0) return bad_.add(fmt::format("{} is negative", keyword.name), here());
      ++count;
    }
    if (count == 1) facts.grey.insert(keyword.name);
    if (count == 0 || count == 2)
      bad_.add(fmt::format("{} has {} numbers where 3 are needed{}", keyword.name, count, cut()), here());
  }

  void check_number(const Keyword& keyword, std::string_view rest) {
    std::string_view word = take_word(rest);
    if (keyword.name == "d" && word == "-halo") {
      facts_.back().unshown.emplace_back("d -halo");
      std::fill_n(text_.begin() + std::ptrdiff_t(position(word)), word.size(), ' ');
      word = take_word(rest);
    }
    if (word.empty()) return bad_.add(fmt::format("{} without a number{}", keyword.name, cut()), here());
    if (is_usable(word, keyword.name) && number_of(word) < 0)
      bad_.add(fmt::format("{} is negative", keyword.name), here());
  }

  std::size_t position(std::string_view part) const { return std::size_t(part.data() - text_.data()); }
  std::string here() const { return at_line(file_, line_); }
  const char* cut() const { return truncated_ ? "; the file ends in the middle of this line" : ""; }

  std::string& text_;
  const std::filesystem::path& file_;
  std::size_t most_;
  RepeatedProblem bad_;
  RepeatedProblem unknown_;
  std::vector<Facts> facts_;
  std::size_t line_ = 0;
  bool truncated_ = false;
};

bool changes_texture(const tinyobj::texture_option_t& o) {
  const auto differs = [](const tinyobj::real_t(&v)[3], float neutral) {
    return v[0] != neutral || v[1] != neutral;
  };
  return differs(o.origin_offset, 0) || differs(o.scale, 1) || differs(o.turbulence, 0) || o.clamp ||
         o.brightness != 0 || o.contrast != 1;
}

glm::vec3 color(const tinyobj::real_t (&c)[3], std::string_view keyword, const Facts& facts) {
  return facts.grey.contains(keyword) ? glm::vec3(c[0]) : glm::vec3(c[0], c[1], c[2]);
}

TextLine texture(const std::string& name, std::string_view keyword, const Facts& facts) {
  const auto found = facts.lines.find(keyword);
  return {std::string(stripped(name)), found == facts.lines.end() ? 0 : found->second};
}

MtlMaterial convert(const tinyobj::material_t& parsed, Facts facts, const std::filesystem::path& file) {
  MtlMaterial m;
  m.name = stripped(parsed.name);
  m.file = file;
  m.line = facts.line;
  m.diffuse_map = texture(parsed.diffuse_texname, "map_Kd", facts);
  m.cutout_map = texture(parsed.alpha_texname, "map_d", facts);
  if (facts.lines.contains("Kd"))
    m.diffuse = color(parsed.diffuse, "Kd", facts);
  else
    m.diffuse = glm::vec3(m.diffuse_map.text.empty() ? 0.8f : 1.0f);
  m.specular = color(parsed.specular, "Ks", facts);
  m.emission = color(parsed.emission, "Ke", facts);
  m.exponent = parsed.shininess;
  m.unshown = std::move(facts.unshown);
  if (parsed.dissolve < 1) m.unshown.emplace_back("transparency (d or Tr)");
  const bool options = (!m.diffuse_map.text.empty() && changes_texture(parsed.diffuse_texopt)) ||
                       (!m.cutout_map.text.empty() && changes_texture(parsed.alpha_texopt));
  if (options) m.unshown.emplace_back("a texture's options (-s, -o, -t, -clamp, -mm)");
  return m;
}

}  // namespace

std::vector<MtlMaterial> load_mtl(const std::filesystem::path& file, ProblemList& problems,
                                  std::size_t most) {
  std::string text = read_file(file, kLargestTextFile);
  if (text.starts_with("\xEF\xBB\xBF")) text.replace(0, 3, "   ");
  if (text.find('\0') != text.npos) throw Error("is not a text file: it has zero bytes", file.string());
  const std::vector<Facts> facts = MtlChecker(text, file, problems, most).run();
  std::map<std::string, int> unused;
  std::vector<tinyobj::material_t> parsed;
  std::string ignored;
  std::istringstream stream(text);
  tinyobj::LoadMtl(&unused, &parsed, &stream, &ignored, &ignored);
  std::vector<MtlMaterial> materials;
  std::map<std::string, std::size_t> lines;
  RepeatedProblem duplicates(problems, Problem::Severity::warning, "materials that stand in the file twice",
                             file.string());
  for (std::size_t i = 0; i < std::min(facts.size(), parsed.size()); ++i) {
    MtlMaterial m = convert(parsed[i], facts[i], file);
    const auto [first, inserted] = lines.try_emplace(m.name, m.line);
    if (!inserted)
      duplicates.add(
          fmt::format("material '{}' stands in line {} too; the first one counts", m.name, first->second),
          at_line(file, m.line));
    else
      materials.push_back(std::move(m));
  }
  return materials;
}

}  // namespace lightbench
