// Face against face, as in collide_box_faces.cpp for boxes, but with faces of any number of corners.
#include <cmath>

#include "pushback/common/collision/collide_hull.h"

namespace pushback {

namespace {

/// Two faces of most_corners - 1 corners each, as the bases of two pyramids, and room for rounding.
constexpr std::size_t room = 2 * most_corners;

/// The feature id of a point in which two edges of one hull meet.
std::uint32_t name_of_corner(const Polyhedron& solid, int edge, int other, bool of_b) {
  const Polyhedron::Edge &e = solid.edges[std::size_t(edge)], &o = solid.edges[std::size_t(other)];
  if (e.from == o.from || e.from == o.to) return of_b ? corner_of_b(e.from) : corner_of_a(e.from);
  if (e.to == o.from || e.to == o.to) return of_b ? corner_of_b(e.to) : corner_of_a(e.to);
  // Two edges meet without a common corner only if a very short edge between them has cut nothing off.
  return (of_b ? 0x50000u : 0x40000u) | std::uint32_t(std::min(edge, other)) << 8 |
         std::uint32_t(std::max(edge, other));
}

}  // namespace

void touch_at_faces(const HullPair& pair, const HullFace& face, Manifold& found) {
  const PlacedPolyhedron& hull = face.of_b ? pair.b : pair.a;  // the hull with the reference face
  const PlacedPolyhedron& incident = face.of_b ? pair.a : pair.b;
  const Polyhedron::Face& reference_face = hull.solid.faces[std::size_t(face.face)];
  const Vec3& normal = hull.normal(face.face);
  const Vec3& origin = hull.on(face.face);
  const Vec3 u_axis = hull.along(reference_face.edges[0]).normalized(), v_axis = normal.cross(u_axis);

  const Polyhedron::Face& incident_face = incident.solid.faces[std::size_t(face_below(incident, normal, pair.clearly))];
  Outline<room> outline;
  int arriving = incident_face.edges.back();
  for (std::size_t k = 0; k < incident_face.corners.size(); ++k) {
    const Vec3 from = incident.corner(incident_face.corners[k]) - origin;
    outline.add({u_axis.dot(from), v_axis.dot(from), -normal.dot(from), arriving, incident_face.edges[k]});
    arriving = incident_face.edges[k];
  }
  const Real tolerance = Real(1e-3) * std::min(reference_face.half_width, incident_face.half_width);
  for (std::size_t k = 0; k < reference_face.corners.size(); ++k) {
    const Vec3 start = hull.corner(reference_face.corners[k]) - origin;
    const std::size_t next = k + 1 == reference_face.corners.size() ? 0 : k + 1;
    const Vec3 side = hull.corner(reference_face.corners[next]) - origin - start;
    const Vec3 outward = side.cross(normal).normalized();
    const Real u = u_axis.dot(outward), v = v_axis.dot(outward), limit = outward.dot(start);
    cut(
        outline, [&](const OutlinePoint& p) { return u * p.u + v * p.v - limit; }, tolerance,
        reference + reference_face.edges[k]);
  }

  const auto corner_name = [&](bool of_reference, int one, int other) {
    return name_of_corner(of_reference ? hull.solid : incident.solid, one, other, of_reference == face.of_b);
  };
  const auto candidates = candidates_of(outline, face.of_b, pair.rounding + pair.margin, pair.clearly, corner_name);
  for (const Candidate& one : candidates) {
    found.add(origin + one.u * u_axis + one.v * v_axis - one.depth / 2 * normal, one.depth, one.feature);
  }
}

}  // namespace pushback
