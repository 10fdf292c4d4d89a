#include "pushback/common/live/lit.h"

#include <algorithm>

#include "pushback/common/experiment/marks.h"
#include "pushback/common/render/palette.h"

namespace pushback {

namespace {

/// In front of all bodies, at the same place of the picture.
Arrow in_front(const Camera& camera, const Vec3& tail, const Vec3& tip) {
  constexpr Real nearer = Real(0.3);
  const Real thickness = 2 * nearer * arrow_thickness(camera, tip);
  return {camera.eye + nearer * (tail - camera.eye), camera.eye + nearer * (tip - camera.eye), thickness, lit_colour()};
}

bool is_impulse(const Arrow& arrow) {
  return arrow.colour == normal_arrow_colour() || arrow.colour == friction_arrow_colour();
}

void light_impulses(Picture& picture) {
  const Camera& camera = picture.camera;
  Real longest = 0;  // as a fraction of the picture's height
  for (const Arrow& arrow : picture.arrows)
    if (is_impulse(arrow)) longest = std::max(longest, (arrow.tip - arrow.tail).norm() / camera.height_at(arrow.tip));
  const Real longer = std::clamp(Real(0.13) / longest, Real(1), Real(3));
  for (Arrow& arrow : picture.arrows)
    if (is_impulse(arrow)) arrow = in_front(camera, arrow.tail, arrow.tail + longer * (arrow.tip - arrow.tail));
}

}  // namespace

void light(Picture& picture, const World& world, const Vec3& shift, Lit lit) {
  if (lit == Lit::impulses) light_impulses(picture);
  if (lit != Lit::normals && lit != Lit::depths) return;
  const Camera& camera = picture.camera;
  for (const Contact& contact : world.contacts) {
    if (contact.parted) continue;
    const Vec3 point = contact.point + shift, along = Real(0.2) * camera.height_at(point) * contact.normal;
    if (lit == Lit::normals) {
      picture.arrows.push_back(in_front(camera, point, point + along));
      continue;
    }
    const Vec3 half = contact.depth / 2 * contact.normal;
    picture.arrows.push_back(in_front(camera, point + half + along, point + half));
    picture.arrows.push_back(in_front(camera, point - half - along, point - half));
  }
}

}  // namespace pushback
