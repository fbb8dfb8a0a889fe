#include "povexport/povray.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <locale>
#include <regex>
#include <sstream>

#include <fmt/format.h>
#include <glm/vec3.hpp>

#include "base/color.h"
#include "base/error.h"
#include "base/files.h"
#include "base/image_io.h"
#include "base/process.h"
#include "base/text.h"
#include "base/utf8.h"

namespace lightbench {
namespace {

constexpr const char* kSceneName = "scene.pov";
constexpr const char* kLibraryName = "library";
constexpr const char* kImageName = "image.exr";

/// Neither the user's nor the system's settings of POV-Ray take part: they are looked for in HOME and POVINI.
std::map<std::string, std::string> environment(const std::filesystem::path& folder) {
  return {{"HOME", folder.string()}, {"POVINI", (folder / "empty.ini").string()}, {"LC_ALL", "C"}};
}

/// What POV-Ray says about the scene: of the first "File 'scene.pov' line 7: Parse Error: ..." the words that
/// matter, with file and line in front.
std::string parse_error(const std::string& log) {
  static const std::regex pattern(R"(File '([^']*)' line (\d+): ((?:Possible )?Parse Error: .*))");
  constexpr std::size_t kLongestLine = 1000;  // std::regex recurses with the length of its input
  for (const std::string& line : split(log, '\n')) {
    std::smatch match;
    if (line.size() <= kLongestLine && std::regex_search(line, match, pattern))
      return match[1].str() + ":" + match[2].str() + ": " + match[3].str();
  }
  return "";
}

/// "3.7.0" of "... POV-Ray 3.7.0 ...". Not std::regex, which recurses with the length of its input.
std::string version_in(std::string_view said) {
  constexpr std::string_view kName = "POV-Ray ";
  constexpr std::size_t kLongest = 100;
  for (std::size_t at = 0; (at = said.find(kName, at)) != std::string_view::npos;) {
    at += kName.size();
    const std::string_view version = said.substr(at, said.find_first_of(" \t\r\n", at) - at);
    if (!version.empty() && version[0] >= '0' && version[0] <= '9' && version.size() <= kLongest)
      return clean_utf8(version);
  }
  return "";
}

[[noreturn]] void fail(const std::string& what, const PovrayRun& run, const std::string& log) {
  const std::string parse = parse_error(log);
  const std::string reason = parse.empty() ? join(last_lines(log, 12), "\n") : parse;
  throw Error("povray " + what + (reason.empty() ? "" : ":\n" + reason), run.scene_file.string());
}

void link_into(const std::filesystem::path& folder, const std::filesystem::path& target, const char* name) {
  std::error_code code;
  const auto absolute = std::filesystem::absolute(target);
  if (!std::filesystem::exists(absolute)) throw Error("there is no such file or folder", target.string());
  std::filesystem::create_symlink(absolute, folder / name, code);
  if (code) throw Error("cannot be linked to: " + code.message(), target.string());
}

ProcessOptions process_of(const PovrayRun& run, const std::filesystem::path& folder) {
  ProcessOptions process;
  process.argv = {run.program.string(), std::string("+I") + kSceneName, std::string("+O") + kImageName,
                  std::string("+L") + kLibraryName};
  for (const std::string& argument : povray_arguments(run)) process.argv.push_back(argument);
  process.working_directory = folder;
  process.environment = environment(folder);
  process.timeout = run.timeout;
  process.idle_timeout = run.idle_timeout;
  return process;
}

Image read_result(const std::filesystem::path& file, const PovrayRun& run, const std::string& log) {
  if (!std::filesystem::exists(file)) fail("ended without an error, yet wrote no image", run, log);
  Image image = read_float_image(file);
  if (image.width != run.width * run.samples || image.height != run.height * run.samples ||
      image.channels != 4)
    fail("wrote an image of another size or without alpha", run, log);
  const auto bad = std::ranges::find_if(image.data, [](float value) { return std::isnan(value); });
  if (bad != image.data.end()) {
    const std::ptrdiff_t pixel = (bad - image.data.begin()) / image.channels;
    fail("wrote NaN at pixel " + std::to_string(pixel % image.width) + ", " +
             std::to_string(pixel / image.width),
         run, "");
  }
  return image;
}

/// POV-Ray writes halves, in which what is too bright for them is infinite. Returns warnings.
std::vector<std::string> clamp_infinite(Image& image) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < image.data.size(); ++i) {
    if (!std::isinf(image.data[i])) continue;
    image.data[i] = std::copysign(kLargestHalf, image.data[i]);
    ++count;
  }
  if (count == 0) return {};
  return {
      fmt::format("{} of {} numbers that POV-Ray wrote are beyond {:.0f}, the largest 16-bit float, and "
                  "count as that",
                  count, image.data.size(), kLargestHalf)};
}

/// The colour that the scene file declares as Background; black if it declares none.
glm::vec3 declared_background(const std::filesystem::path& scene_file) {
  glm::vec3 color(0);
  std::istringstream text(read_file(scene_file));
  text.imbue(std::locale::classic());
  constexpr std::string_view kDeclaration = "#declare Background=<";
  char comma = 0;
  for (std::string line; std::getline(text, line);)
    if (line.starts_with(kDeclaration)) {
      std::istringstream numbers(line.substr(kDeclaration.size()));
      numbers.imbue(std::locale::classic());
      numbers >> color.x >> comma >> color.y >> comma >> color.z;
      break;
    }
  return color;
}

/// The background shows where nothing is; POV-Ray leaves such pixels black with alpha 0.
void put_over_background(Image& image, const glm::vec3& background) {
  for (std::size_t i = 0; i < image.pixel_count(); ++i)
    for (int c = 0; c < 3; ++c)
      image.data[4 * i + std::size_t(c)] += (1.0f - image.data[4 * i + 3]) * background[c];
}

}  // namespace

std::filesystem::path find_povray() {
  const char* given = std::getenv("LIGHTBENCH_POVRAY");
  const std::string name = given != nullptr && *given != '\0' ? given : "povray";
  const std::filesystem::path program = find_program(name);
  if (!program.empty()) return program;
  throw Error(
      "POV-Ray is not there: install it (Debian: apt-get install povray) or set LIGHTBENCH_POVRAY to it",
      name);
}

std::string povray_version(const std::filesystem::path& program) {
  const TemporaryFolder folder("lightbench-povray");
  write_file_atomic(folder.path() / "empty.ini", "");
  ProcessOptions process;
  process.argv = {program.string(), "--version"};
  process.working_directory = folder.path();
  process.environment = environment(folder.path());
  process.timeout = std::chrono::seconds(20);
  const ProcessResult result = run_process(process);
  const std::string version = version_in(result.out + "\n" + result.err);
  if (!version.empty()) return version;
  throw Error("does not say its version (" + result.describe() + "); is it POV-Ray 3.7?", program.string());
}

std::vector<std::string> povray_arguments(const PovrayRun& run) {
  return {"+W" + std::to_string(run.width * run.samples),
          "+H" + std::to_string(run.height * run.samples),
          "+FE",   // EXR, half floats
          "+UA",   // with alpha
          "+WT1",  // radiosity differs from run to run with more threads
          "+Q9",
          "-A",
          "-C",
          "-D",
          "-P",
          "-V"};
}

PovrayImage run_povray(const PovrayRun& run) {
  check_image_size(static_cast<long long>(run.width) * run.samples,
                   static_cast<long long>(run.height) * run.samples, run.scene_file.string());
  const TemporaryFolder folder("lightbench-povray");
  write_file_atomic(folder.path() / "empty.ini", "");
  link_into(folder.path(), run.scene_file, kSceneName);
  link_into(folder.path(), run.library, kLibraryName);

  const ProcessResult result = run_process(process_of(run, folder.path()));
  const std::string log = result.err + result.out;
  if (!result.ok()) fail(result.describe(), run, log);
  if (log.find("No objects in scene") != std::string::npos)
    fail("found no objects: the scene is empty", run, "");
  Image image = read_result(folder.path() / kImageName, run, log);
  PovrayImage rendered;
  rendered.warnings = clamp_infinite(image);
  put_over_background(image, declared_background(run.scene_file));

  rendered.image = run.samples > 1 ? box_downsample(image, run.samples) : std::move(image);
  rendered.seconds = result.seconds;
  rendered.cpu_seconds = result.cpu_seconds;
  rendered.log = log;
  rendered.arguments = povray_arguments(run);
  return rendered;
}

}  // namespace lightbench
