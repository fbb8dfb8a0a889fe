#include "scene/ear_clipper.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace lightbench {
namespace {

// A polygon of a model is seldom quite flat: edges that cross by this share of its area do not count.
constexpr double kTolerance = 1e-3;

bool repeats(std::vector<glm::dvec2> points) {
  const auto before = [](const glm::dvec2& a, const glm::dvec2& b) {
    return a.x != b.x ? a.x < b.x : a.y < b.y;
  };
  std::sort(points.begin(), points.end(), before);
  return std::adjacent_find(points.begin(), points.end()) != points.end();
}

// The next smallest one that has not been dealt with.
template <typename Heap>
std::optional<std::uint32_t> pop(Heap& heap) {
  if (heap.empty()) return std::nullopt;
  const std::uint32_t i = heap.top();
  while (!heap.empty() && heap.top() == i) heap.pop();
  return i;
}

}  // namespace

double turn_of(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  // Kahan's difference of products: what is 0 stays 0 however the compiler joins products and sums.
  const glm::dvec2 u = b - a;
  const glm::dvec2 v = c - a;
  const double right = u.y * v.x;
  const double lost = std::fma(-u.y, v.x, right);
  return std::fma(u.x, v.y, -right) + lost;
}

EarClipper::EarClipper(const std::vector<glm::dvec2>& points, std::vector<glm::uvec3>& triangles,
                       ClippingBudget& budget)
    : points_(points),
      triangles_(triangles),
      budget_(budget),
      grid_(points),
      clipped_(points.size()),
      turns_(points.size()),
      has_repeats_(repeats(points)),
      left_(points.size()),
      waiting_(points.size()) {
  const auto n = std::uint32_t(points.size());
  for (std::uint32_t i = 0; i < n; ++i) {
    before_.push_back((i + n - 1) % n);
    after_.push_back((i + 1) % n);
  }
  for (std::uint32_t i = 0; i < n; ++i) look_again_at(i);
}

bool EarClipper::run() {
  while (left_ > 3) {
    const std::uint32_t next = next_corner();
    if (steps_ > budget_.steps || last_resort_steps_ > budget_.last_resort_steps) {
      budget_ = {0, 0};
      fan();
      return false;
    }
    clip(next);
  }
  fan();
  budget_.steps -= std::min(budget_.steps, steps_);
  budget_.last_resort_steps -= std::min(budget_.last_resort_steps, last_resort_steps_);
  return wrong_ <= kTolerance * covered_;
}

std::uint32_t EarClipper::next_corner() {
  if (const auto next = ear()) return *next;
  if (const auto next = fold()) return *next;
  const std::size_t before = steps_;
  std::optional<std::uint32_t> next = touching_ear();
  if (!next) {
    next = flattest();
    wrong_ += std::abs(turns_[*next]);
  }
  last_resort_steps_ += steps_ - before;
  return *next;
}

// The rest as a fan around its first corner; of a triangle, the triangle.
void EarClipper::fan() {
  for (std::uint32_t i = after_[first_]; after_[i] != first_; i = after_[i]) add(first_, i, after_[i]);
}

// Where a polygon meets itself in a corner, it may go around its parts in opposite ways.
void EarClipper::add(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  const double turn = turn_of(points_[a], points_[b], points_[c]);
  covered_ += std::abs(turn);
  if (turn < 0 && has_repeats_) std::swap(a, c);
  if (turn < 0 && !has_repeats_) wrong_ -= turn;
  triangles_.emplace_back(a, b, c);
}

bool EarClipper::is_fold(std::uint32_t i) const {
  const glm::dvec2 back = points_[before_[i]] - points_[i];
  const glm::dvec2 on = points_[after_[i]] - points_[i];
  return turns_[i] == 0 && (back == glm::dvec2(0) || on == glm::dvec2(0) || glm::dot(back, on) > 0);
}

void EarClipper::look_again_at(std::uint32_t i) {
  turns_[i] = turn_of(points_[before_[i]], points_[i], points_[after_[i]]);
  if (turns_[i] > 0) ears_.push(i);
  if (is_fold(i)) folds_.push(i);
}

void EarClipper::clip(std::uint32_t i) {
  const std::uint32_t a = before_[i];
  const std::uint32_t c = after_[i];
  add(a, i, c);
  clipped_[i] = true;
  after_[a] = c;
  before_[c] = a;
  --left_;
  while (clipped_[first_]) ++first_;
  for (const std::uint32_t changed : {a, c}) look_again_at(changed);
  for (const std::uint32_t changed : {a, i, c})
    for (const std::uint32_t waiting : std::exchange(waiting_[changed], {}))
      if (!clipped_[waiting]) look_again_at(waiting);
}

// The first corner in order that is an ear for sure.
std::optional<std::uint32_t> EarClipper::ear() {
  while (const auto i = pop(ears_)) {
    if (clipped_[*i] || turns_[*i] <= 0) continue;
    const auto in_the_way = blocker(*i, Mode::strict);
    if (!in_the_way) return i;
    waiting_[*in_the_way].push_back(*i);
  }
  return std::nullopt;
}

// A corner where the polygon runs back over itself: without it, it goes around the same.
std::optional<std::uint32_t> EarClipper::fold() {
  while (const auto i = pop(folds_))
    if (!clipped_[*i] && is_fold(*i)) return i;
  return std::nullopt;
}

// An ear whose new edge other corners touch. Of a polygon that goes around its parts in opposite ways, where
// they meet in a corner, one part's ears turn to the right.
std::optional<std::uint32_t> EarClipper::touching_ear() {
  std::uint32_t i = first_;
  for (std::size_t k = 0; k < left_; ++k, i = after_[i]) {
    const bool may_be_ear = has_repeats_ ? turns_[i] != 0 : turns_[i] > 0;
    if (may_be_ear && !blocker(i, Mode::touching) && is_inside_polygon(i)) return i;
  }
  return std::nullopt;
}

std::uint32_t EarClipper::flattest() {
  std::uint32_t flattest = first_;
  for (std::uint32_t i = after_[first_]; i != first_; i = after_[i], ++steps_)
    if (std::abs(turns_[i]) < std::abs(turns_[flattest])) flattest = i;
  return flattest;
}

// Whether the edge from a corner in or on the ear's triangle leads into it. `sides` says on which side of its
// three edges the corner is.
bool EarClipper::goes_inside(std::uint32_t corner, std::uint32_t to, const glm::dvec3& sides,
                             std::uint32_t ear) const {
  if (to == corner) return false;
  const glm::dvec2& a = points_[before_[ear]];
  const glm::dvec2& b = points_[ear];
  const glm::dvec2& c = points_[after_[ear]];
  const double sign = turns_[ear] < 0 ? -1 : 1;
  const glm::dvec2& p = points_[to];
  return (sides.x > 0 || sign * turn_of(a, b, p) > 0) && (sides.y > 0 || sign * turn_of(b, c, p) > 0) &&
         (sides.z > 0 || sign * turn_of(c, a, p) > 0);
}

// A corner that keeps `ear` from being one, if there is any: nothing of the polygon may lead into the ear's
// triangle. Of corners that lie in it, some do not turn to the left, so that the others need no look, but at
// its own corners any may lie. Where one lies on the ear's tip, both edges of the ear may be covered by edges
// that run the other way, with nothing between them, so then its inside must be looked at, too.
std::optional<std::uint32_t> EarClipper::blocker(std::uint32_t ear, Mode mode) {
  const std::uint32_t ia = before_[ear], ic = after_[ear];
  const glm::dvec2 &a = points_[ia], &b = points_[ear], &c = points_[ic];
  const double sign = turns_[ear] < 0 ? -1 : 1;
  std::optional<std::uint32_t> found;
  std::optional<std::uint32_t> on_tip;
  const glm::dvec2 min = glm::min(glm::min(a, b), c), max = glm::max(glm::max(a, b), c);
  grid_.visit(min, max, [&](std::uint32_t i) {
    ++steps_;
    const glm::dvec2& p = points_[i];
    if (p.x < min.x || p.x > max.x || p.y < min.y || p.y > max.y) return false;
    if (clipped_[i] || i == ia || i == ear || i == ic) return false;
    const bool at_corner = p == a || p == b || p == c;
    if (!at_corner && sign * turns_[i] > 0) return false;
    const glm::dvec3 sides = sign * glm::dvec3(turn_of(a, b, p), turn_of(b, c, p), turn_of(c, a, p));
    if (sides.x < 0 || sides.y < 0 || sides.z < 0) return false;
    const bool touches = mode == Mode::strict && !at_corner;
    if (touches || goes_inside(i, before_[i], sides, ear) || goes_inside(i, after_[i], sides, ear)) found = i;
    if (p == b) on_tip = i;
    return found.has_value();
  });
  if (!found && on_tip && mode == Mode::strict && !is_inside_polygon(ear)) return on_tip;
  return found;
}

// Whether what is left of the polygon goes around the middle of the ear an odd number of times.
bool EarClipper::is_inside_polygon(std::uint32_t ear) {
  const glm::dvec2 middle = (points_[before_[ear]] + points_[ear] + points_[after_[ear]]) / 3.0;
  bool odd = false;
  std::uint32_t i = first_;
  for (std::size_t k = 0; k < left_; ++k, ++steps_, i = after_[i]) {
    const glm::dvec2& p = points_[i];
    const glm::dvec2& q = points_[after_[i]];
    if ((p.y > middle.y) == (q.y > middle.y)) continue;
    if ((turn_of(p, q, middle) > 0) == (q.y > p.y)) odd = !odd;
  }
  return odd;
}

}  // namespace lightbench
