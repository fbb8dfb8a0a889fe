#include "scene/light_json.h"

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "scene/scene_json.h"

namespace lightbench {
namespace {

constexpr double kLargestDistance = 1e15;
constexpr double kLargestPower = 1e6;
constexpr double kSmallestPositive = 1e-9;

// Beyond this a spotlight's shadow map and POV-Ray's spotlight have no meaning.
constexpr double kWidestSpot = 89.0;

// Along one edge of an area light.
constexpr int kMostPoints = 64;

// Edges that enclose a smaller share of their lengths are parallel in 32-bit floats.
constexpr float kSmallestArea = 1e-6f;

const std::vector<std::string> kLightTypes{"point", "directional", "spot", "area"};

float positive(const JsonValue& value) {
  return float(value.number(kSmallestPositive, kLargestDistance));
}

Attenuation read_attenuation(const JsonValue& value) {
  JsonObject object = value.object();
  Attenuation a;
  const std::string type = object.at("type").choice({"none", "fade", "inverse_square", "radius"});
  if (type == "fade") {
    a.kind = Attenuation::Kind::fade;
    a.distance = positive(object.at("distance"));
    if (const auto power = object.find("power")) a.power = float(power->number(kSmallestPositive, 100));
  } else if (type == "inverse_square") {
    a.kind = Attenuation::Kind::inverse_square;
  } else if (type == "radius") {
    a.kind = Attenuation::Kind::radius;
    a.radius = positive(object.at("radius"));
  }
  object.finish();
  return a;
}

void read_spot(KeyReader& keys, Light& light) {
  keys.required("position", [&](const JsonValue& v) { light.position = read_point(v); });
  if (keys.has("direction") == keys.has("look_at"))
    keys.fail("a spotlight needs either 'direction' or 'look_at'");
  keys.optional("direction", [&](const JsonValue& v) { light.direction = read_direction(v); });
  keys.optional("look_at", [&](const JsonValue& v) {
    const glm::dvec3 direction(read_point(v) - light.position);  // short ones have no length in 32 bits
    if (!(glm::length(direction) > 0)) v.fail("the spotlight's look_at is its position");
    light.direction = glm::vec3(glm::normalize(direction));
  });
  keys.required("outer", [&](const JsonValue& v) {
    light.outer_angle = float(glm::radians(v.number(kSmallestPositive, kWidestSpot)));
  });
  keys.optional("inner", [&](const JsonValue& v) {
    light.inner_angle = float(glm::radians(v.number(0, kWidestSpot)));
    if (light.outer_angle > 0 && light.inner_angle > light.outer_angle)
      v.fail("the inner angle is larger than the outer one");
  });
}

int read_point_count(const JsonValue& value) {
  return int(value.integer(1, kMostPoints));
}

bool encloses_area(const Light& light) {
  const float area = glm::length(glm::cross(light.edge_u, light.edge_v));
  return area > kSmallestArea * glm::length(light.edge_u) * glm::length(light.edge_v);
}

void read_quad(KeyReader& keys, Light& light) {
  keys.required("position", [&](const JsonValue& v) { light.position = read_point(v); });
  keys.required("edge_u", [&](const JsonValue& v) {
    light.edge_u = read_point(v);
    if (light.edge_u == glm::vec3(0)) v.fail("the area light has no area: an edge is zero");
  });
  keys.required("edge_v", [&](const JsonValue& v) {
    light.edge_v = read_point(v);
    if (light.edge_u != glm::vec3(0) && !encloses_area(light))
      v.fail("the area light has no area: its edges are parallel or zero");
  });
  keys.optional("points", [&](const JsonValue& v) {
    const std::vector<JsonValue> counts = v.items();
    if (counts.size() != 2) v.fail("must be two numbers: the points along edge_u and along edge_v");
    light.points = {read_point_count(counts[0]), read_point_count(counts[1])};
  });
}

void read_triangle(KeyReader& keys, Light& light) {
  light.shape = AreaShape::triangle;
  keys.required("triangle", [&](const JsonValue& v) {
    const std::vector<JsonValue> corners = v.items();
    if (corners.size() != 3) v.fail("must be three corners");
    light.position = read_point(corners[0]);
    light.edge_u = read_point(corners[1]) - light.position;
    light.edge_v = read_point(corners[2]) - light.position;
    if (!encloses_area(light)) v.fail("the area light has no area: its corners lie on a line");
  });
  keys.optional("points", [&](const JsonValue& v) { light.points = glm::ivec2(read_point_count(v)); });
}

// Whether the light is meant as an emitting surface.
bool read_emitter(KeyReader& keys) {
  bool lambert = false;
  keys.optional("emitter", [&](const JsonValue& v) {
    lambert = v.choice({"points", "lambert"}) == "lambert";
  });
  for (const char* key : {"points", "attenuation"})
    if (lambert && keys.has(key))
      keys.fail(fmt::format("an emitter 'lambert' is a surface: it has no '{}'", key));
  return lambert;
}

void read_kind(KeyReader& keys, LightEntry& entry) {
  Light& light = entry.light;
  switch (light.kind) {
    case LightKind::point:
      return keys.required("position", [&](const JsonValue& v) { light.position = read_point(v); });
    case LightKind::directional:
      return keys.required("direction", [&](const JsonValue& v) { light.direction = read_direction(v); });
    case LightKind::spot:
      return read_spot(keys, light);
    case LightKind::area:
      entry.emitting_surface = read_emitter(keys);
      return keys.has("triangle") ? read_triangle(keys, light) : read_quad(keys, light);
  }
}

}  // namespace

LightEntry read_light(const JsonValue& value, ProblemList& problems) {
  KeyReader keys(value, problems);
  LightEntry entry;
  Light& light = entry.light;
  std::string type;
  keys.required("type", [&](const JsonValue& v) { type = v.choice(kLightTypes); });
  if (type.empty()) return entry;
  light.kind = LightKind(std::find(kLightTypes.begin(), kLightTypes.end(), type) - kLightTypes.begin());
  light.name = type;
  keys.optional("name", [&](const JsonValue& v) { light.name = read_name(v); });
  keys.optional("color", [&](const JsonValue& v) { light.color = read_color(v); });
  keys.optional("power", [&](const JsonValue& v) { light.power = float(v.number(0, kLargestPower)); });
  read_kind(keys, entry);
  if (light.kind != LightKind::directional)
    keys.optional("attenuation", [&](const JsonValue& v) { light.attenuation = read_attenuation(v); });
  keys.finish();
  if (light.power == 0 || light.color == glm::vec3(0))
    problems.warning(fmt::format("the light '{}' gives no light", light.name), value.where());
  return entry;
}

}  // namespace lightbench
