#include "scene/water_json.h"

#include <cmath>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "scene/scene_json.h"

namespace lightbench {
namespace {

constexpr double kLargest = 1e9;
constexpr double kSmallestPositive = 1e-9;
constexpr int kMostVertices = 2048;  // along an edge
constexpr double kLargestIor = 10;

glm::vec2 read_place(const JsonValue& value) {
  const std::vector<double> numbers = value.numbers(2);
  for (const double number : numbers)
    if (std::abs(number) > kLargest) value.fail(fmt::format("{} is too large a coordinate", number));
  return {float(numbers[0]), float(numbers[1])};
}

glm::vec2 read_wave_direction(const JsonValue& value) {
  const glm::dvec2 direction(read_place(value));
  if (!(glm::length(direction) > 0)) value.fail("a direction must not be zero");
  return glm::vec2(glm::normalize(direction));
}

Wave read_wave(const JsonValue& value, ProblemList& problems) {
  Wave wave;
  KeyReader keys(value, problems);
  keys.required("amplitude", [&](const JsonValue& v) { wave.amplitude = float(v.number(0, kLargest)); });
  keys.required("wavelength",
                [&](const JsonValue& v) { wave.wavelength = float(v.number(kSmallestPositive, kLargest)); });
  keys.required("direction", [&](const JsonValue& v) { wave.direction = read_wave_direction(v); });
  keys.optional("speed", [&](const JsonValue& v) { wave.speed = float(v.number(-kLargest, kLargest)); });
  keys.optional("phase", [&](const JsonValue& v) { wave.phase = float(glm::radians(v.number(-1e6, 1e6))); });
  keys.finish();
  return wave;
}

std::vector<Wave> read_waves(const JsonValue& list, ProblemList& problems) {
  std::vector<Wave> waves;
  for (const JsonValue& item : list.items()) waves.push_back(read_wave(item, problems));
  return waves;
}

glm::ivec2 read_grid(const JsonValue& value) {
  const std::vector<double> numbers = value.numbers(2);
  for (const double number : numbers)
    if (!(number >= 2 && number <= kMostVertices) || number != std::floor(number))
      value.fail(fmt::format("a grid has 2 to {} vertices along an edge, not {}", kMostVertices, number));
  return {int(numbers[0]), int(numbers[1])};
}

/// Waves that the grid's vertices cannot show.
void check_waves(const Water& water, const std::string& where, ProblemList& problems) {
  const glm::vec2 cell = (water.max - water.min) / glm::vec2(water.grid - 1);
  for (std::size_t i = 0; i < water.waves.size(); ++i) {
    const Wave& wave = water.waves[i];
    const float across = glm::dot(glm::abs(wave.direction), cell);
    if (wave.amplitude > 0 && wave.wavelength < 4 * across)
      problems.warning(fmt::format("wave {} has fewer than 4 of the water's vertices on a length: "
                                   "a finer grid would show it",
                                   i),
                       where);
  }
}

}  // namespace

Water read_water(const JsonValue& value, ProblemList& problems) {
  Water water;
  KeyReader keys(value, problems);
  keys.required("min", [&](const JsonValue& v) { water.min = read_place(v); });
  keys.required("max", [&](const JsonValue& v) {
    water.max = read_place(v);
    if (!(water.min.x < water.max.x && water.min.y < water.max.y))
      v.fail("the water is empty: min must be below max in each component");
  });
  keys.required("height", [&](const JsonValue& v) { water.height = float(v.number(-kLargest, kLargest)); });
  keys.optional("grid", [&](const JsonValue& v) { water.grid = read_grid(v); });
  keys.optional("ior", [&](const JsonValue& v) { water.ior = float(v.number(1, kLargestIor)); });
  keys.optional("absorption", [&](const JsonValue& v) { water.absorption = read_color(v); });
  keys.optional("ambient", [&](const JsonValue& v) { water.ambient = read_color(v); });
  keys.optional("waves", [&](const JsonValue& v) { water.waves = read_waves(v, problems); });
  keys.finish();
  check_waves(water, keys.where(), problems);
  return water;
}

}  // namespace lightbench
