#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <vector>

#include <solver/base/face_corners.hpp>
#include <solver/base/hexahedron_of_points.hpp>
#include <solver/mesh/element_types.hpp>
#include <solver/mesh/mesh_file.hpp>
#include <solver/mesh/quality.hpp>

/// What the tables of types say agrees with the geometry of what they say it of.
namespace pinball::element_types_test {
namespace {

/// A wedge of half a cube and so on, by their corners.
const std::map<SolidShape, std::vector<Point>>& places() {
  static const std::map<SolidShape, std::vector<Point>> all{
      {SolidShape::hexahedron,
       {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}},
      {SolidShape::wedge, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}}},
      {SolidShape::pyramid, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}}},
      {SolidShape::tetrahedron, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}};
  return all;
}

std::array<Point, 8> corners_of(const KnownShape& shape) {
  std::array<Point, 8> corners;
  for (std::size_t i = 0; i < 8; ++i) corners[i] = places().at(shape.shape)[shape.stored[i]];
  return corners;
}

std::array<std::int32_t, 4> side_of(const KnownShape& shape, const std::array<int, 4>& corners) {
  std::array<std::int32_t, 4> side{};
  for (std::size_t i = 0; i < 4; ++i) side[i] = shape.stored[corners[i]];
  return side;
}

/// The faces that are no lines or points, as what they are found by.
std::set<std::array<std::int32_t, 4>> faces_of(const KnownShape& shape) {
  std::set<std::array<std::int32_t, 4>> faces;
  for (std::size_t face = 0; face < 6; ++face) {
    const auto key = face_key(face_of(shape.stored, face));
    if (key[2] >= 0) faces.insert(key);
  }
  return faces;
}

/// Twice the area of a face times its normal, of the first three of its corners.
Point normal_of(const KnownShape& shape, const std::array<std::int32_t, 4>& face) {
  const std::vector<Point>& at = places().at(shape.shape);
  return cross(minus(at[face[1]], at[face[0]]), minus(at[face[2]], at[face[0]]));
}

TEST(ElementTypes, AreStoredWithTheVolumeOfTheirShape) {
  const std::map<SolidShape, double> volumes{{SolidShape::hexahedron, 1},
                                             {SolidShape::wedge, 0.5},
                                             {SolidShape::pyramid, 1.0 / 3},
                                             {SolidShape::tetrahedron, 1.0 / 6}};
  ASSERT_EQ(known_shapes().size(), volumes.size());
  for (const KnownShape& shape : known_shapes()) {
    SCOPED_TRACE(shape.plural);
    EXPECT_NEAR(volume_by_quadrature(corners_of(shape)), volumes.at(shape.shape), 1e-15);
    EXPECT_EQ(different_nodes(shape.stored), places().at(shape.shape).size());
    EXPECT_EQ(shape_of(shape.stored), shape.shape);
    EXPECT_EQ(worked_as(shape.stored), shape.worked);
    EXPECT_EQ(&known_shape(shape.shape), &shape);
    EXPECT_NEAR(element_size(shape.worked, corners_of(shape)).volume, volumes.at(shape.shape), 1e-15);
  }
}

TEST(ElementTypes, NumberEachFaceOnceInEachFormat) {
  for (const KnownShape& shape : known_shapes()) {
    SCOPED_TRACE(shape.plural);
    std::set<std::array<std::int32_t, 4>> of_abaqus, of_exodus;
    for (const int face : shape.abaqus_faces) {
      if (face >= 0) {
        EXPECT_TRUE(of_abaqus.insert(face_key(face_of(shape.stored, face))).second);
      }
    }
    for (const auto& side : shape.exodus_sides) {
      if (side[0] >= 0) {
        EXPECT_TRUE(of_exodus.insert(face_key(side_of(shape, side))).second);
      }
    }
    EXPECT_EQ(of_abaqus, faces_of(shape));
    EXPECT_EQ(of_exodus, faces_of(shape));
  }
}

TEST(ElementTypes, HaveSidesThatAreSeenFromOutside) {
  for (const KnownShape& shape : known_shapes()) {
    SCOPED_TRACE(shape.plural);
    const std::vector<Point>& at = places().at(shape.shape);
    Point middle{};
    for (const Point& corner : at) {
      for (std::size_t k = 0; k < 3; ++k) middle[k] += corner[k] / at.size();
    }
    for (const auto& side : shape.exodus_sides) {
      if (side[0] < 0) continue;
      const auto face = side_of(shape, side);
      EXPECT_GT(dot(normal_of(shape, face), minus(at[face[0]], middle)), 0) << testing::PrintToString(side);
    }
  }
}

TEST(ElementTypes, AreFoundInResultsAsTheyWereStored) {
  const Corners8 nodes{10, 11, 12, 13, 14, 15, 16, 17};
  for (const KnownShape& shape : known_shapes()) {
    SCOPED_TRACE(shape.plural);
    Corners8 stored;
    for (std::size_t i = 0; i < 8; ++i) stored[i] = nodes[shape.stored[i]];
    std::vector<std::int32_t> cell(stored.begin(), stored.end());
    if (!shape.cell.empty()) cell.clear();
    for (const int corner : shape.cell) cell.push_back(stored[corner]);
    EXPECT_EQ(corners_of_cell(cell), stored);
  }
}

TEST(ElementTypes, HaveNumbersAndNamesOfTheirOwn) {
  std::set<int> gmsh, vtk;
  std::set<std::pair<std::string_view, int>> exodus;
  for (const ElementType& type : element_types()) {
    EXPECT_GE(type.nodes, static_cast<int>(places().at(type.shape).size()));
    if (type.gmsh != 0) {
      EXPECT_TRUE(gmsh.insert(type.gmsh).second) << type.gmsh;
    }
    if (type.vtk != 0) {
      EXPECT_TRUE(vtk.insert(type.vtk).second) << type.vtk;
    }
    if (!type.exodus.empty()) {
      EXPECT_TRUE(exodus.insert({type.exodus, type.nodes}).second) << type.exodus;
    }
    if (type.gmsh != 0) {
      EXPECT_EQ(element_type(&ElementType::gmsh, type.gmsh), &type);
    }
    if (type.vtk != 0) {
      EXPECT_EQ(element_type(&ElementType::vtk, type.vtk), &type);
    }
    if (!type.radioss.empty()) {
      EXPECT_EQ(element_type(&ElementType::radioss, type.radioss), &type);
    }
    if (!type.abaqus.empty()) {
      EXPECT_EQ(element_type(&ElementType::abaqus, type.abaqus.substr(0, type.abaqus.find(' '))), &type);
    }
    std::array<int, 8> order = type.order, counted{};
    std::ranges::sort(order);
    std::iota(counted.begin(), counted.end(), 0);
    EXPECT_EQ(order, counted);
  }
  EXPECT_EQ(element_type(&ElementType::gmsh, 0), nullptr);
  EXPECT_EQ(element_type(&ElementType::abaqus, "C3D"), nullptr);
  EXPECT_EQ(element_type(&ElementType::radioss, ""), nullptr);
  EXPECT_EQ(element_type(&ElementType::abaqus, "C3D8RH")->shape, SolidShape::hexahedron);
}

TEST(ElementTypes, OfFewerCornersInAnotherWayAreWorkedAsTheirShape) {
  EXPECT_EQ(worked_as({0, 1, 2, 3, 4, 4, 5, 5}), WorkedShape::wedge);  // a roof
  EXPECT_EQ(shape_of({0, 1, 2, 3, 4, 4, 5, 5}), SolidShape::hexahedron);
  EXPECT_EQ(worked_as({0, 1, 2, 3, 4, 5, 6, 6}), WorkedShape::hexahedron);
  EXPECT_EQ(worked_as({0, 1, 2, 2, 3, 3, 3, 3}), WorkedShape::hexahedron);  // four nodes, not stored as tetrahedra are
}

TEST(ElementTypes, PutNodesOfEdgesBesideTheirCorners) {
  MeshFile file;
  const std::vector<std::int32_t> nodes{0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
  append_element(file, *element_type(&ElementType::gmsh, 4), nodes);
  append_element(file, *element_type(&ElementType::gmsh, 11), nodes);
  EXPECT_THAT(file.mesh.hexahedra, testing::Each(tetrahedron(0, 1, 2, 3)));
  ASSERT_EQ(file.edge_nodes.size(), 1u);
  EXPECT_EQ(file.edge_nodes[0].element, 1);
  EXPECT_THAT(file.edge_nodes[0].nodes, testing::ElementsAre(4, 5, 6, 7, 8, 9));
}

TEST(ElementTypes, AreListedByTheirNames) {
  EXPECT_EQ(names_of_shapes(), "hexahedra, wedges, pyramids or tetrahedra");
  EXPECT_EQ(names_of_types(&ElementType::vtk), "hexahedra (12, 11), wedges (13), pyramids (14) or tetrahedra (10, 24)");
}

}  // namespace
}  // namespace pinball::element_types_test
