#include "scene/obj_keywords.h"

#include <algorithm>
#include <array>

#include "scene/text_scan.h"

namespace lightbench {
namespace {

struct Keyword {
  std::string_view name;
  ObjStatement statement;
};

constexpr std::array kKeywords{
    Keyword{"v", ObjStatement::vertex},          Keyword{"vt", ObjStatement::uv},
    Keyword{"vn", ObjStatement::normal},         Keyword{"f", ObjStatement::face},
    Keyword{"fo", ObjStatement::face},  // what faces were called before version 3.0 of the format
    Keyword{"usemtl", ObjStatement::material},   Keyword{"g", ObjStatement::group},
    Keyword{"o", ObjStatement::object},          Keyword{"s", ObjStatement::smoothing},
    Keyword{"mtllib", ObjStatement::library},    Keyword{"l", ObjStatement::line_or_point},
    Keyword{"p", ObjStatement::line_or_point},   Keyword{"curv", ObjStatement::free_form},
    Keyword{"curv2", ObjStatement::free_form},   Keyword{"surf", ObjStatement::free_form},
    Keyword{"parm", ObjStatement::free_form},    Keyword{"trim", ObjStatement::free_form},
    Keyword{"hole", ObjStatement::free_form},    Keyword{"scrv", ObjStatement::free_form},
    Keyword{"sp", ObjStatement::free_form},      Keyword{"con", ObjStatement::free_form},
    Keyword{"bmat", ObjStatement::free_form},    Keyword{"step", ObjStatement::free_form},
    Keyword{"cdc", ObjStatement::free_form},     Keyword{"vp", ObjStatement::ignored},
    Keyword{"vw", ObjStatement::ignored},        Keyword{"t", ObjStatement::ignored},
    Keyword{"mg", ObjStatement::ignored},        Keyword{"bevel", ObjStatement::ignored},
    Keyword{"c_interp", ObjStatement::ignored},  Keyword{"d_interp", ObjStatement::ignored},
    Keyword{"lod", ObjStatement::ignored},       Keyword{"shadow_obj", ObjStatement::ignored},
    Keyword{"trace_obj", ObjStatement::ignored}, Keyword{"ctech", ObjStatement::ignored},
    Keyword{"stech", ObjStatement::ignored},     Keyword{"deg", ObjStatement::ignored},
    Keyword{"cstype", ObjStatement::ignored},    Keyword{"end", ObjStatement::ignored},
};

std::optional<ObjStatement> find_exactly(std::string_view keyword) {
  const auto found =
      std::find_if(kKeywords.begin(), kKeywords.end(), [&](const Keyword& k) { return k.name == keyword; });
  return found == kKeywords.end() ? std::nullopt : std::optional(found->statement);
}

}  // namespace

std::optional<ObjStatement> find_obj_statement(std::string_view keyword) {
  const auto found = find_exactly(keyword);
  return found ? found : find_exactly(lower_case(keyword));
}

}  // namespace lightbench
