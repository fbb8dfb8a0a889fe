#include "scene/scene_file.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

#include "base/error.h"
#include "base/files.h"
#include "base/hash.h"
#include "base/text.h"
#include "scene/box_mesh.h"
#include "scene/emitting_surface.h"
#include "scene/light_json.h"
#include "scene/light_points.h"
#include "scene/material_overrides.h"
#include "scene/motion.h"
#include "scene/nearest_surface.h"
#include "scene/scene_check.h"
#include "scene/scene_json.h"
#include "scene/scene_models.h"
#include "scene/transform.h"
#include "scene/water_json.h"

namespace lightbench {
namespace fs = std::filesystem;
namespace {

// After this many errors the rest of a list is not read.
constexpr std::size_t kMostErrors = 1000;

constexpr std::size_t kMostEntities = 1'000'000;

class SceneLoader {
 public:
  LoadedScene load_json(const fs::path& file) {
    file_ = file;
    scene_.name = file.stem().string();
    try {
      std::optional<JsonValue> text;
      std::string hash = hash_while_reading(file, [&] { text = JsonValue::parse_file(file); });
      models_.add_file({file, std::move(hash)});
      read_scene(*text);
    } catch (const Error& error) {
      problems_.add(error);
    }
    return finish();
  }

  LoadedScene load_bare_obj(const fs::path& file) {
    file_ = file;
    scene_.name = file.stem().string();
    try {
      Entity entity{.name = scene_.name};
      const PlacedModel placed = models_.model(file, {});
      entity.transform = model_transform(glm::dmat4(1), glm::mat4(1), placed.origin);
      check_distance(placed, entity, file.string(), problems_);
      add_entities(placed, entity);
    } catch (const Error& error) {
      problems_.add(error);
    }
    Light sun;
    sun.name = "default";
    sun.kind = LightKind::directional;
    sun.direction = glm::normalize(glm::vec3(-0.5f, -1.0f, -0.35f));
    scene_.lights.push_back(sun);
    scene_.background.color = glm::vec3(0.3f);
    problems_.note(
        "a bare OBJ is lit by a default light: directional, direction (-0.5, -1, -0.35), colour 1, and a "
        "background "
        "of 0.3",
        file.string());
    return finish();
  }

 private:
  void read_scene(const JsonValue& root) {
    KeyReader keys(root, problems_);
    keys.optional("name", [&](const JsonValue& v) { scene_.name = read_name(v); });
    keys.required("entities",
                  [&](const JsonValue& v) { read_list(v, [&](const auto& e) { read_entity(e); }); });
    keys.optional("materials", [&](const JsonValue& v) { read_overrides(v); });
    keys.optional("lights", [&](const JsonValue& v) {
      read_list(v, [&](const auto& e) { add_light(read_light(e, problems_), e.where()); });
    });
    keys.optional("background", [&](const JsonValue& v) { read_background(v); });
    keys.optional("water", [&](const JsonValue& v) { scene_.water = read_water(v, problems_); });
    keys.optional("near", [&](const JsonValue& v) { scene_.near = float(v.number(1e-9, 1e15)); });
    keys.optional("far", [&](const JsonValue& v) {
      scene_.far = float(v.number(1e-9, 1e15));
      if (scene_.near && *scene_.near >= *scene_.far) v.fail("far must be larger than near");
    });
    keys.optional("credits", [&](const JsonValue& v) {
      read_list(v, [&](const auto& e) { scene_.credits.push_back(read_credit(e)); });
    });
    keys.finish();
  }

  // Each item's problem is listed, and the next one read.
  template <typename Read>
  void read_list(const JsonValue& list, Read read) {
    const std::size_t before = problems_.errors();
    for (const JsonValue& item : list.items()) {
      if (problems_.errors() - before > kMostErrors)
        return problems_.error("there are too many errors: the rest is not read", list.where());
      try {
        read(item);
      } catch (const Error& error) {
        problems_.add(error);
      }
    }
  }

  void add_light(const LightEntry& entry, const std::string& where) {
    if (light_points_ > kMostLightPoints) return;
    light_points_ += entry.emitting_surface ? 1 : light_point_count(entry.light);
    if (light_points_ > kMostLightPoints)
      throw Error(fmt::format("the lights have more than {} points in all", kMostLightPoints), where);
    if (!entry.emitting_surface) return scene_.lights.push_back(entry.light);
    // One of the wrong shape is a problem already.
    if (!problems_.has_errors()) add_emitting_surface(scene_, entry.light);
    problems_.warning(
        fmt::format("light '{}' is an emitting surface: only indirect light takes it in", entry.light.name),
        where);
  }

  void read_background(const JsonValue& value) {
    KeyReader keys(value, problems_);
    keys.optional("color", [&](const JsonValue& v) { scene_.background.color = read_color(v); });
    keys.optional("lights", [&](const JsonValue& v) { scene_.background.lights = v.boolean(); });
    keys.finish();
  }

  void read_entity(const JsonValue& value) {
    const JsonObject object(value);
    if (object.has("obj") == object.has("box")) return object.fail("an entity needs either 'obj' or 'box'");
    KeyReader keys(value, problems_);
    if (object.has("obj"))
      read_obj_entity(keys);
    else
      read_box_entity(keys);
    keys.finish();
  }

  void read_obj_entity(KeyReader& keys) {
    Entity entity;
    glm::mat4 shape(1);  // what turns and scales the model before it is placed
    ModelOptions options;
    std::optional<PlacedModel> placed;
    const glm::dmat4 place = read_place(keys, entity);
    keys.optional("up", [&](const JsonValue& v) {
      if (v.choice({"y", "z"}) == "z") shape = glm::mat4(rotation_degrees({-90, 0, 0}));
    });
    keys.optional("crease_angle", [&](const JsonValue& v) { options.crease_angle = v.number(0, 180); });
    keys.optional("vertex_colors", [&](const JsonValue& v) {
      if (v.choice({"srgb", "linear"}) == "linear") options.vertex_colors = VertexColors::linear;
    });
    keys.required("obj", [&](const JsonValue& v) {
      const fs::path file = resolve_path(v.text(), file_.parent_path(), v.where());
      if (entity.name.empty()) entity.name = file.stem().string();
      // An OBJ that is not there is a problem of this key.
      std::error_code ignored;
      if (!fs::exists(file, ignored)) v.fail(fmt::format("there is no file '{}'", file.string()));
      placed = models_.model(file, options);
    });
    keys.optional("size", [&](const JsonValue& v) {
      if (!placed) return;
      shape = fit(v, *placed, shape) * shape;
      placed->origin = glm::dvec3(0);  // The model's own place no longer counts.
    });
    if (!placed) return;
    entity.transform = model_transform(place, shape, placed->origin);
    check_distance(*placed, entity, keys.where(), problems_);
    add_entities(*placed, entity);
  }

  // What all kinds of entities say of where they stand: reads their name and motion, and returns the
  // transform.
  static glm::dmat4 read_place(KeyReader& keys, Entity& entity) {
    glm::dmat4 place(1);
    keys.optional("name", [&](const JsonValue& v) { entity.name = read_name(v); });
    keys.optional("transform", [&](const JsonValue& v) { place = read_transform(v); });
    keys.optional("keyframes", [&](const JsonValue& v) { entity.motion.keys = read_motion(v); });
    return place;
  }

  // Scales the turned model to a box that stands centred on its footprint.
  glm::mat4 fit(const JsonValue& value, const PlacedModel& placed, const glm::mat4& up) {
    const glm::vec3 size = read_point(value);
    if (!(size.x > 0 && size.y > 0 && size.z > 0)) value.fail("a size must be larger than 0");
    Bounds bounds;
    for (int i = 0; i < placed.mesh_count; ++i)
      for (const glm::vec3& p : scene_.meshes[std::size_t(placed.first_mesh) + std::size_t(i)].positions)
        bounds.add(transform_point(up, p));
    if (bounds.empty()) return glm::mat4(1);
    glm::vec3 scale(1);
    for (int k = 0; k < 3; ++k)
      if (bounds.max[k] > bounds.min[k]) scale[k] = size[k] / (bounds.max[k] - bounds.min[k]);
    const glm::vec3 center = bounds.center();
    return glm::translate(glm::scale(glm::mat4(1), scale), -glm::vec3(center.x, bounds.min.y, center.z));
  }

  void read_box_entity(KeyReader& keys) {
    Entity entity{.name = "box"};
    Bounds box;
    MaterialPatch patch;
    entity.transform = glm::mat4(read_place(keys, entity));
    keys.optional("material", [&](const JsonValue& v) { patch = read_material_patch(v, problems_); });
    keys.required("box", [&](const JsonValue& v) {
      JsonObject object = v.object();
      box.min = read_point(object.at("min"));
      box.max = read_point(object.at("max"));
      object.finish();
      if (!(box.min.x < box.max.x && box.min.y < box.max.y && box.min.z < box.max.z)) {
        box = Bounds();
        v.fail("the box is empty: min must be below max in each component");
      }
    });
    if (box.empty()) return;
    Material& material = scene_.materials.emplace_back();
    material.name = entity.name;
    patch.apply(material);
    scene_.meshes.push_back(box_mesh(entity.name, box, int(scene_.materials.size()) - 1));
    entity.mesh = int(scene_.meshes.size()) - 1;
    add_entity(entity);
  }

  // An entity like `whole` for each mesh of the model.
  void add_entities(const PlacedModel& placed, const Entity& whole) {
    for (int i = placed.first_mesh; i < placed.first_mesh + placed.mesh_count; ++i) {
      const std::string& part = scene_.meshes[std::size_t(i)].name;
      Entity entity = whole;
      entity.mesh = i;
      if (placed.mesh_count > 1 && !part.empty()) entity.name += "/" + part;
      add_entity(std::move(entity));
    }
  }

  void add_entity(Entity entity) {
    if (scene_.entities.size() == kMostEntities)
      throw Error(fmt::format("the scene has more than {} entities", kMostEntities), file_.string());
    entity.motion.rest = entity.transform;
    scene_.entities.push_back(std::move(entity));
  }

  void read_overrides(const JsonValue& value) {
    MaterialOverrides overrides(scene_.materials, models_.unused_materials(), problems_, value.where());
    JsonObject object = value.object();
    for (const std::string& name : object.keys()) {
      const JsonValue patch_value = object.at(name);
      try {
        overrides.apply(name, read_material_patch(patch_value, problems_), patch_value.where());
      } catch (const Error& error) {
        problems_.add(error);
      }
    }
  }

  LoadedScene finish() {
    for (const SourceFile& texture : textures_.files()) scene_.files.push_back(texture);
    scene_.textures = textures_.take_textures();
    set_time(scene_, 0);
    check_scene(scene_, file_, problems_);
    return {std::move(scene_), problems_.all()};
  }

  fs::path file_;
  Scene scene_;
  ProblemList problems_;
  TextureLoader textures_{problems_};
  SceneModels models_{scene_, textures_, problems_};
  std::size_t light_points_ = 0;  // of all lights up to the first one that is too much
};

std::string lower_case_extension(const fs::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  return extension;
}

}  // namespace

LoadedScene load_scene_collecting(const fs::path& file) {
  const std::string extension = lower_case_extension(file);
  if (extension == ".obj") return SceneLoader().load_bare_obj(file);
  if (extension == ".json") return SceneLoader().load_json(file);
  LoadedScene nothing;
  nothing.problems.push_back(
      {Problem::Severity::error, "a scene is a scene file (.json) or a model (.obj)", file.string()});
  return nothing;
}

Scene load_scene(const fs::path& file) {
  LoadedScene loaded = load_scene_collecting(file);
  for (const Problem& problem : loaded.problems) {
    if (problem.severity == Problem::Severity::error) throw Error(problem.what, problem.where);
    if (problem.severity == Problem::Severity::warning)
      loaded.scene.warnings.push_back(problem.where.empty() ? problem.what
                                                            : problem.where + ": " + problem.what);
  }
  return std::move(loaded.scene);
}

}  // namespace lightbench
