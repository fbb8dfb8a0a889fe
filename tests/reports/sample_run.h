#pragma once

#include "reports/run_report.h"

namespace lightbench::test {

/// Names and messages that would break out of HTML, XML, Markdown, JSON, a terminal or a line format.
inline constexpr const char* kHostileScene = "</script><img src=x onerror=alert(1)>";
inline constexpr const char* kHostileView = "a|b \"c\" 'd' & `e` é\x1b[31m\n\xff";
inline constexpr const char* kHostileObject = "<b>wall</b>|`x`";
inline constexpr const char* kHostileError = "]]> <b>bold</b> | \x01 ${HOME} $(rm) %s {0}";

/// Two scenes, one with a hostile name; a baseline, a variant, and one whose task failed on the second view.
/// Two objects of the first scene, one with a hostile name that could be baked but not compressed.
RunReport sample_run();

}  // namespace lightbench::test
