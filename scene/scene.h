#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "base/image.h"

/// A scene as plain data. World space is right-handed, y up, in the scene's own units; angles are radians;
/// all colours are linear.
namespace lightbench {

struct Texture {
  std::filesystem::path file;
  Image8 pixels;  ///< RGBA, 8 bits; the colour is sRGB-encoded; row 0 is the image's top (v = 1)
};

/// A lookup into Scene::textures.
using TextureIndex = int;
inline constexpr TextureIndex kNoTexture = -1;

struct Material {
  std::string name;
  glm::vec3 diffuse{0.8f};                    ///< Kd; multiplied by the texture and the vertex colour
  float specular = 0;                         ///< mean of Ks
  float exponent = 1;                         ///< Ns, of Phong's R.V
  glm::vec3 emission{0};                      ///< Ke, radiance
  float reflectance = 1;                      ///< radiation mask: scales the indirect light it receives
  TextureIndex diffuse_texture = kNoTexture;  ///< map_Kd, bilinear, repeated
  TextureIndex cutout_texture =
      kNoTexture;  ///< map_d: its alpha component counts; below 0.5 nothing is there
};

/// Consecutive triangles of a mesh that share a material.
struct MeshPart {
  int material = 0;
  std::uint32_t first_triangle = 0;
  std::uint32_t triangle_count = 0;
};

struct Mesh {
  std::string name;
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;  ///< unit; one per position
  std::vector<glm::vec2> uvs;      ///< one per position, or empty; v points up
  std::vector<glm::vec3> colors;   ///< linear, one per position, or empty
  std::vector<glm::uvec3> triangles;
  std::vector<MeshPart> parts;  ///< cover all triangles, in order
};

/// Where a moving entity stands at a time: scaled, then turned about x, then y, then z, then moved. The scale
/// is not 0, and of the same sign in all keyframes of a motion.
struct MotionKey {
  double time = 0;  ///< seconds
  glm::dvec3 translate{0};
  glm::dvec3 rotate{0};  ///< degrees
  glm::dvec3 scale{1};
};

/// How an entity moves; scene/motion.h says where it is at a time.
struct Motion {
  glm::mat4 rest{1};            ///< the transform that the keyframes are applied after
  std::vector<MotionKey> keys;  ///< times rise strictly; empty: it stands still
};

struct Entity {
  std::string name;
  int mesh = 0;
  glm::mat4 transform{1};  ///< object to world, affine, not singular; of a moving entity, at Scene::time
  Motion motion = {};
};

struct Attenuation {
  enum class Kind {
    none,
    fade,            ///< 2 / (1 + (d / distance)^power)
    inverse_square,  ///< 1 / d^2
    radius,          ///< saturate(1 - (d / radius)^2), the image-space radiosity thesis's eq. 16
  };
  Kind kind = Kind::none;
  float distance = 1;
  float power = 2;
  float radius = 1;
};

/// The factor at distance d > 0.
float attenuation_factor(const Attenuation& attenuation, float d);

enum class LightKind { point, directional, spot, area };
enum class AreaShape { quad, triangle };

/// colour * power is the radiance that a white diffuse surface facing the light shows where the attenuation
/// is 1.
struct Light {
  std::string name;
  LightKind kind = LightKind::point;
  glm::vec3 position{0};          ///< point, spot; centre of a quad, first corner of a triangle
  glm::vec3 direction{0, -1, 0};  ///< unit, the way the light travels; directional, spot
  glm::vec3 color{1};
  float power = 1;
  Attenuation attenuation;  ///< ignored by directional lights
  float inner_angle = 0;    ///< spot: half-angle of the full cone
  float outer_angle = 0;    ///< spot: half-angle where it ends; between them smoothstep in the cosine
  AreaShape shape = AreaShape::quad;
  glm::vec3 edge_u{0};  ///< area: full edges of the quad; from a triangle's first corner to the other two
  glm::vec3 edge_v{0};
  glm::ivec2 points{4};  ///< area: of the grid along the edges; a triangle has x * x of equal areas
};

/// A constant emitter around the scene.
struct Background {
  glm::vec3 color{0};
  bool lights = true;  ///< whether indirect light gathers it
};

/// One of the sines that the water's surface is the sum of:
/// amplitude sin(2 pi / wavelength (direction . (x, z) - speed t) + phase).
struct Wave {
  float amplitude = 0;
  float wavelength = 1;
  glm::vec2 direction{1, 0};  ///< unit, of x and z: where it runs to
  float speed = 0;            ///< in units a second
  float phase = 0;            ///< radians
};

/// A rectangle of water, above which is air; everything below it is in the water.
struct Water {
  glm::vec2 min{0};  ///< x and z
  glm::vec2 max{0};
  float height = 0;         ///< y where it is flat
  glm::ivec2 grid{71, 71};  ///< vertices along x and z
  float ior = 1.333f;       ///< over that of air
  glm::vec3 absorption{0};  ///< for each unit of length: exp(-absorption d) passes
  glm::vec3 ambient{0};     ///< what light from all sides adds to all surfaces, times their colour
  std::vector<Wave> waves;
};

struct Camera {
  glm::vec3 position{0};
  glm::vec3 look_at{0, 0, -1};
  glm::vec3 up{0, 1, 0};
  float fov = 1.0471976f;  ///< vertical, radians
};

/// Right-handed orthonormal frame of a camera; up is perpendicular to the view direction.
struct CameraFrame {
  glm::vec3 right;
  glm::vec3 up;
  glm::vec3 forward;
};
CameraFrame camera_frame(const Camera& camera);

struct CameraKey {
  double time = 0;  ///< seconds
  Camera camera;
};

/// Which frame of which sequence a view is. Each frame is a still view of its own; only what compares frames
/// looks at this.
struct SequenceFrame {
  std::string sequence;
  int number = 0;  ///< from 0 on
};

struct View {
  std::string name;
  Camera camera;    ///< at `time`
  double time = 0;  ///< seconds; where moving entities stand
  std::optional<SequenceFrame> frame = {};
  std::vector<CameraKey> keyframes = {};  ///< times rise strictly; empty: the camera stands still
  std::string where = {};                 ///< the place in the camera script, for errors
};

/// Who made a piece of the scene, for the report.
struct Credit {
  std::string piece;
  std::string creator;
  std::string license;
};

struct Bounds {
  glm::vec3 min{std::numeric_limits<float>::max()};
  glm::vec3 max{std::numeric_limits<float>::lowest()};

  bool empty() const { return min.x > max.x; }
  void add(const glm::vec3& p);
  glm::vec3 center() const { return 0.5f * (min + max); }
  float diagonal() const;
};

/// A file that was read for a scene.
struct SourceFile {
  std::filesystem::path path;
  std::string hash;  ///< of what it held when it was read
};

struct Scene {
  std::string name;
  std::vector<Texture> textures;
  std::vector<Material> materials;
  std::vector<Mesh> meshes;
  std::vector<Entity> entities;
  double time = 0;  ///< seconds; where moving entities stand: `set_time` changes it
  std::vector<Light> lights;
  Background background;
  std::optional<Water> water;
  std::optional<float> near;  ///< as given by the scene file
  std::optional<float> far;
  std::vector<Credit> credits;
  std::vector<std::string> warnings;  ///< what the scene has that lightbench does not show as it is
  std::vector<SourceFile> files;      ///< everything that was read, in order
};

std::vector<std::filesystem::path> file_paths(const Scene& scene);

/// Of an entity, where it stands at Scene::time.
Bounds entity_bounds(const Scene& scene, std::size_t entity);
/// Of all entities, moving ones where they stand at Scene::time.
Bounds world_bounds(const Scene& scene);
std::size_t triangle_count(const Scene& scene);  ///< of all entities, instances counted each
std::size_t texture_bytes(const Scene& scene);   ///< that the pixels of all textures take in memory

/// Distances along the view direction between which the view is drawn.
struct DepthRange {
  float near;
  float far;
};
/// The scene's own near and far where given. Else far is where the bounds end; near is nearer than anything
/// in front of the camera, even for a picture three times as wide as the view, and lies between far / 10^6
/// and far / 100. Meant for depth buffers of 32-bit floats. Visits all triangles: milliseconds, so ask once a
/// view.
DepthRange depth_range(const Scene& scene, const Camera& camera);

}  // namespace lightbench
