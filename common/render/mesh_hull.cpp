// A polyhedron with bevels. Each face is drawn a little smaller, a strip along each edge and a patch at each corner
// close the gaps, and the normals turn from face to face across them.
#include <array>

#include "pushback/common/render/mesh.h"

namespace pushback {
namespace {

using Eigen::Vector3f;

void add_polygon(Mesh& mesh, const std::vector<std::uint16_t>& loop) {
  for (std::size_t k = 2; k < loop.size(); ++k) {
    mesh.indices.insert(mesh.indices.end(), {loop[0], loop[k - 1], loop[k]});
  }
}

}  // namespace

Mesh bevelled(const Polyhedron& solid, float radius) {
  Mesh mesh;
  const Vector3f half_extents = half_extents_of(solid);
  constexpr int nobody = -1;
  std::array<std::array<int, most_corners>, most_corners> vertex_of{}, face_of{};  // of the side from i to j
  for (auto& row : face_of) row.fill(nobody);
  for (std::size_t f = 0; f < solid.faces.size(); ++f) {
    const Polyhedron::Face& face = solid.faces[f];
    const std::size_t count = face.corners.size();
    std::vector<std::uint16_t> loop;
    for (std::size_t k = 0; k < count; ++k) {
      const int here = face.corners[k], next = face.corners[(k + 1) % count];
      const Vec3& corner = solid.corners[std::size_t(here)];
      const Vec3 ahead = (solid.corners[std::size_t(next)] - corner).normalized();
      const Vec3 back = (solid.corners[std::size_t(face.corners[(k + count - 1) % count])] - corner).normalized();
      // Inset by `radius` from both sides.
      const Vec3 inset = corner + Real(radius) / ahead.cross(back).norm() * (ahead + back);
      const Vec3 below = inset - Real(radius) * face.normal;
      loop.push_back(static_cast<std::uint16_t>(mesh.vertices.size()));
      face_of[std::size_t(here)][std::size_t(next)] = int(f);
      vertex_of[std::size_t(here)][std::size_t(next)] = loop.back();
      mesh.vertices.push_back({below.cast<float>().cwiseQuotient(half_extents), face.normal.cast<float>()});
    }
    add_polygon(mesh, loop);
  }
  const auto next_corner = [&](int face, int from) {
    const std::vector<int>& corners = solid.faces[std::size_t(face)].corners;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      if (corners[k] == from) return corners[(k + 1) % corners.size()];
    }
    return nobody;
  };
  const auto vertex = [&](int face, int corner) {
    return static_cast<std::uint16_t>(vertex_of[std::size_t(corner)][std::size_t(next_corner(face, corner))]);
  };
  for (const Polyhedron::Edge& edge : solid.edges) {
    add_polygon(mesh, {vertex(edge.left, edge.to), vertex(edge.left, edge.from), vertex(edge.right, edge.from),
                       vertex(edge.right, edge.to)});
  }
  for (int corner = 0; corner < int(solid.corners.size()); ++corner) {
    int first = 0;
    while (face_of[std::size_t(corner)][std::size_t(first)] == nobody) ++first;
    // Goes around the corner: the side that leaves the corner on one face comes back to it on the face to the right.
    std::vector<std::uint16_t> patch;
    for (int to = first; patch.empty() || to != first;) {
      const int left = face_of[std::size_t(corner)][std::size_t(to)];
      patch.insert(patch.begin(), vertex(left, corner));
      to = next_corner(face_of[std::size_t(to)][std::size_t(corner)], corner);
    }
    add_polygon(mesh, patch);
  }
  return mesh;
}

Eigen::Vector3f half_extents_of(const Polyhedron& solid) {
  Vec3 reach = Vec3::Zero();
  for (const Vec3& corner : solid.corners) reach = reach.cwiseMax(corner.cwiseAbs());
  return reach.cast<float>();
}

Mesh cut_back(Mesh mesh) {
  for (Vertex& vertex : mesh.vertices) vertex.normal *= 0.65f;
  return mesh;
}

}  // namespace pushback
