#include "scene/mtl_loader.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <strings.h>

#include "base/files.h"
#include "scene/named_files.h"
#include "scene/obj_text.h"
#include "scene/text_scan.h"

namespace lightbench {
namespace {

enum class Use {
  new_material,
  color,  ///< one or three numbers, not negative
  number,
  texture,
  ambient_texture,  ///< not shown, as ambient light is none; most files name the texture of map_Kd once more
  ignored,          ///< means nothing in lightbench's lighting model
  unshown,          ///< would change the picture, and is not shown
};

struct Keyword {
  std::string_view name;  ///< files write it in any case
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
    Keyword{"map_Ka", Use::ambient_texture},
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

// A material while its statements are read.
struct Draft {
  MtlMaterial material;
  bool used = true;
  bool has_diffuse = false;
  std::optional<double> dissolve;  // d
  double transparency = 0;         // Tr; d counts where both are given
  std::string ambient_map;
  std::set<std::string_view> maps;  // keywords of those that were read
};

class MtlReader {
 public:
  MtlReader(const std::filesystem::path& file, ProblemList& problems, std::size_t most,
            const std::function<bool(const std::string&)>& is_used)
      : file_(file),
        most_(most),
        is_used_(is_used),
        bad_(problems, Problem::Severity::error, "malformed statements", file.string()),
        unused_bad_(problems, Problem::Severity::warning,
                    "malformed statements of materials that no face uses", file.string()),
        odd_(problems, Problem::Severity::warning, "statements that mean nothing", file.string()),
        duplicates_(problems, Problem::Severity::warning, "materials that stand in the file twice",
                    file.string()) {}

  std::vector<MtlMaterial> run(std::string_view text) {
    LineScanner lines(text);
    while (const auto line = lines.next()) {
      line_ = lines.line();
      truncated_ = !lines.ended_by_newline();
      read_line(*line);
    }
    end_material();
    return std::move(materials_);
  }

 private:
  void read_line(std::string_view rest) {
    const std::string_view word = take_word(rest);
    if (word.empty() || word[0] == '#') return;
    const Keyword* keyword = find_keyword(word);
    if (!keyword) return odd_.add(fmt::format("unknown statement '{}'", word.substr(0, 40)), here());
    if (keyword->use == Use::new_material) return begin_material(std::string(stripped(rest)));
    if (!draft_)
      return odd_.add(fmt::format("'{}' before the first newmtl is of no material", keyword->name), here());
    read_statement(*keyword, stripped(rest));
  }

  void begin_material(std::string name) {
    end_material();
    if (++count_ > most_) throw Error(fmt::format("the file has more than {} materials", most_), here());
    draft_.emplace();
    draft_->material.file = file_;
    draft_->material.line = line_;
    if (name.empty()) {
      odd_.add(fmt::format("newmtl without a name: no face can use this material{}", cut()), here());
      draft_->used = false;
      return;
    }
    const auto [first, is_first] = lines_.try_emplace(name, line_);
    draft_->used = is_first && is_used_(name);
    draft_->material.name = std::move(name);
    if (is_first) return;
    duplicates_.add(fmt::format("material '{}' stands in line {} too; the first one counts",
                                draft_->material.name, first->second),
                    here());
  }

  // Keeps the material that was read, unless it has no name or its name was taken.
  void end_material() {
    if (!draft_) return;
    Draft draft = std::move(*draft_);
    draft_.reset();
    MtlMaterial& m = draft.material;
    if (m.name.empty() || lines_.at(m.name) != m.line) return;
    if (!draft.has_diffuse) m.diffuse = glm::vec3(m.diffuse_map.name.empty() ? 0.8f : 1.0f);
    if (draft.dissolve.value_or(1 - draft.transparency) < 1) m.unshown.emplace_back("transparency (d or Tr)");
    if (!draft.ambient_map.empty() && draft.ambient_map != m.diffuse_map.name)
      m.unshown.emplace_back("map_Ka");
    materials_.push_back(std::move(m));
  }

  void read_statement(const Keyword& keyword, std::string_view rest) {
    MtlMaterial& m = draft_->material;
    if (keyword.use == Use::color) read_color(keyword, rest);
    if (keyword.use == Use::number) read_number(keyword, rest);
    if (keyword.use == Use::texture || keyword.use == Use::ambient_texture) read_texture(keyword, rest);
    if (keyword.use == Use::unshown && std::ranges::find(m.unshown, keyword.name) == m.unshown.end())
      m.unshown.emplace_back(keyword.name);
    if (keyword.name == "illum" && number_of(take_word(rest)) >= 3)
      m.unshown.emplace_back("mirror or glass (illum 3 and above)");
  }

  bool is_usable(std::string_view word, std::string_view keyword) {
    if (classify_number(word) == NumberKind::finite) return true;
    bad(fmt::format("{} has '{}', which is no finite number{}", keyword, word.substr(0, 40), cut()));
    return false;
  }

  void read_color(const Keyword& keyword, std::string_view rest) {
    if (keyword.name == "Kd") draft_->has_diffuse = true;
    std::array<float, 3> color{};
    std::size_t count = 0;
    for (std::string_view word = take_word(rest); !word.empty() && word[0] != '#'; word = take_word(rest)) {
      if (word == "spectral" || word == "xyz")
        return bad(fmt::format("{} is given as '{}'; only RGB colours are read", keyword.name, word));
      if (!is_usable(word, keyword.name)) return;
      if (number_of(word) < 0) return bad(fmt::format("{} is negative", keyword.name));
      if (count < 3) color[count] = float(number_of(word));
      ++count;
    }
    if (count == 0 || count == 2)
      return bad(fmt::format("{} has {} numbers where 3 are needed{}", keyword.name, count, cut()));
    const glm::vec3 value = count == 1 ? glm::vec3(color[0]) : glm::vec3(color[0], color[1], color[2]);
    if (keyword.name == "Kd") draft_->material.diffuse = value;
    if (keyword.name == "Ks") draft_->material.specular = value;
    if (keyword.name == "Ke") draft_->material.emission = value;
  }

  void read_number(const Keyword& keyword, std::string_view rest) {
    std::string_view word = take_word(rest);
    if (keyword.name == "d" && word == "-halo") {
      draft_->material.unshown.emplace_back("d -halo");
      word = take_word(rest);
    }
    if (word.empty()) return bad(fmt::format("{} without a number{}", keyword.name, cut()));
    if (!is_usable(word, keyword.name)) return;
    const double value = number_of(word);
    if (value < 0) return bad(fmt::format("{} is negative", keyword.name));
    if (keyword.name == "Ns") draft_->material.exponent = float(value);
    if (keyword.name == "d") draft_->dissolve = value;
    if (keyword.name == "Tr") draft_->transparency = value;
  }

  void read_texture(const Keyword& keyword, std::string_view rest) {
    TextureStatement statement = read_texture_statement(
        rest, [&](const std::string& name) { return is_named_exactly(name, file_.parent_path()); });
    const std::string no_file =
        statement.name.empty() ? fmt::format("{} without a file{}", keyword.name, cut()) : "";
    if (keyword.use == Use::ambient_texture) {
      if (!no_file.empty()) odd_.add(no_file, here());
      draft_->ambient_map = std::move(statement.name);
      return;
    }
    if (!statement.problem.empty()) return bad(fmt::format("{}: {}", keyword.name, statement.problem));
    if (!no_file.empty()) return bad(no_file);
    if (!draft_->maps.insert(keyword.name).second)
      odd_.add(fmt::format("{} stands twice in material '{}'; the last one counts", keyword.name,
                           draft_->material.name),
               here());
    MtlMaterial& m = draft_->material;
    for (const std::string& option : statement.unshown)
      m.unshown.push_back(fmt::format("the texture option {}", option));
    MtlTexture& texture = keyword.name == "map_Kd" ? m.diffuse_map : m.cutout_map;
    texture = {std::move(statement.name), line_, statement.placement};
  }

  // An error in a material that nobody sees does not keep the rest from being used.
  void bad(std::string what) {
    if (draft_->used) return bad_.add(std::move(what), here());
    unused_bad_.add(what + " (no face uses this material)", here());
  }

  std::string here() const { return at_line(file_, line_); }
  const char* cut() const { return truncated_ ? "; the file ends in the middle of this line" : ""; }

  const std::filesystem::path& file_;
  std::size_t most_;
  const std::function<bool(const std::string&)>& is_used_;
  RepeatedProblem bad_;
  RepeatedProblem unused_bad_;
  RepeatedProblem odd_;
  RepeatedProblem duplicates_;
  std::vector<MtlMaterial> materials_;
  std::map<std::string, std::size_t> lines_;  // of the first material of each name
  std::optional<Draft> draft_;
  std::size_t count_ = 0;
  std::size_t line_ = 0;
  bool truncated_ = false;
};

}  // namespace

std::vector<MtlMaterial> load_mtl(const std::filesystem::path& file, ProblemList& problems, std::size_t most,
                                  const std::function<bool(const std::string&)>& is_used) {
  std::string text = read_file(file, kLargestTextFile);
  if (text.starts_with("\xEF\xBB\xBF")) text.replace(0, 3, "   ");
  if (text.find('\0') != text.npos) throw Error("is not a text file: it has zero bytes", file.string());
  return MtlReader(file, problems, most, is_used).run(text);
}

}  // namespace lightbench
