#pragma once

#include <new>
#include <string>

#include "base/error.h"
#include "base/text.h"

namespace lightbench {

/// Sets the library's limits, once.
void configure_openimageio();

/// Calls `action`; whatever the library throws becomes an Error with the file.
template <typename Action>
auto guarded(const std::string& file, const Action& action) {
  try {
    return action();
  } catch (const Error&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw Error("the image does not fit in memory", file);
  } catch (const std::exception& error) {
    throw Error("OpenImageIO fails: " + one_line(error.what()), file);
  }
}

}  // namespace lightbench
