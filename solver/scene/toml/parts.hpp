#pragma once

#include <solver/scene.hpp>

#include "table.hpp"

/// The tables that a scene holds any number of. Each function throws InputError on a missing key or a bad value.
namespace pinball {

/// One [[material]]. Moduli of either kind become K and G; an elastic material carries no yield or erosion data.
Material read_material(const SceneTable& table);

/// What the mesh of a body is read for.
struct MeshScale {
  int refine = 1;          ///< multiplies element counts
  double least_bytes = 0;  ///< memory that a run takes for an element with its nodes
};

/// [element], or body.NAME.element. otherwise: where the table says nothing.
ElementSettings read_element(const SceneTable& table, const ElementSettings& otherwise);

/// One [[body]] of a scene, of which all but bodies has been read. Whether its material exists is not checked.
Body read_body(const SceneTable& table, const Scene& scene);

/// The mesh of a body. Throws InputError for one that this machine's memory cannot hold.
MeshSettings read_mesh(const SceneTable& body, const MeshScale& scale);

}  // namespace pinball
