#include "pipeline/references.h"

#include <algorithm>

#include "base/error.h"
#include "base/text.h"
#include "pipeline/references/light_tracer.h"
#include "pipeline/references/path_tracer.h"
#include "pipeline/references/povray.h"
#include "pipeline/tables.h"

namespace lightbench {

std::span<const ReferenceKind> reference_kinds() {
  static const ReferenceKind table[] = {
      povray_reference(),
      path_tracer_reference(),
      light_tracer_reference(),
  };
  return table;
}

const ReferenceKind& find_reference_kind(const std::string& name, const std::string& where) {
  const auto kinds = reference_kinds();
  const auto found =
      std::find_if(kinds.begin(), kinds.end(), [&](const auto& kind) { return kind.name == name; });
  if (found != kinds.end()) return *found;
  throw Error("unknown reference kind '" + name + "'" + did_you_mean(name, row_names(kinds)) +
                  "; there are: " + join(row_names(kinds), ", "),
              where);
}

}  // namespace lightbench
