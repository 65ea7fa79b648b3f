#include <map>
#include <optional>
#include <string_view>

#include <solver/base/error.hpp>
#include <solver/contact/embedded_contact.hpp>

#include "bindings.hpp"
#include "interpreter_lock.hpp"

namespace pinball::python {

namespace {

using Maybe = std::optional<py::object>;  // an array, or what numpy makes one of

/// The settings that Python names by texts.
const std::map<std::string, std::map<std::string, std::int32_t>> choices{
    {"method", {{"pinball", PINBALL_CONTACT_PINBALL}, {"slideline", PINBALL_CONTACT_SLIDELINE}}},
    {"enforcement",
     {{"penalty", PINBALL_CONTACT_PENALTY},
      {"projection", PINBALL_CONTACT_PROJECTION},
      {"lagrange", PINBALL_CONTACT_LAGRANGE}}},
    {"gap", {{"pinball", PINBALL_CONTACT_GAP_PINBALL}, {"face", PINBALL_CONTACT_GAP_FACE}}},
    {"radius", {{"initial", PINBALL_CONTACT_RADIUS_INITIAL}, {"current", PINBALL_CONTACT_RADIUS_CURRENT}}}};

const std::map<std::string, std::int32_t pinball_contact_options::*> integers{
    {"first_index", &pinball_contact_options::first_index}, {"method", &pinball_contact_options::method},
    {"enforcement", &pinball_contact_options::enforcement}, {"gap", &pinball_contact_options::gap},
    {"radius", &pinball_contact_options::radius},           {"self", &pinball_contact_options::self},
    {"keep_lists", &pinball_contact_options::keep_lists},   {"threads", &pinball_contact_options::threads}};

const std::map<std::string, double pinball_contact_options::*> numbers{
    {"beta", &pinball_contact_options::beta},
    {"damping", &pinball_contact_options::damping},
    {"friction", &pinball_contact_options::friction},
    {"static_friction", &pinball_contact_options::static_friction},
    {"radius_factor", &pinball_contact_options::radius_factor},
    {"skin", &pinball_contact_options::skin}};

std::int32_t integer_of(const std::string& name, const py::handle& value) {
  const auto choice = choices.find(name);
  if (choice == choices.end()) return value.cast<std::int32_t>();
  const auto text = value.cast<std::string>();
  const auto found = choice->second.find(text);
  if (found == choice->second.end()) throw InputError("options." + name + ": unknown value \"" + text + "\"");
  return found->second;
}

pinball_contact_options options_of(const py::kwargs& given) {
  pinball_contact_options options = contact_options();
  for (const auto& [key, value] : given) {
    const auto name = key.cast<std::string>();
    if (const auto integer = integers.find(name); integer != integers.end()) {
      options.*(integer->second) = integer_of(name, value);
    } else if (const auto number = numbers.find(name); number != numbers.end()) {
      options.*(number->second) = value.cast<double>();
    } else {
      throw py::type_error("Contact: there is no option \"" + name + "\"");
    }
  }
  return options;
}

/// What is an error of arguments is an InputError, as elsewhere.
[[noreturn]] void throw_python(const EmbeddedContactError& error) {
  if (error.status() == PINBALL_CONTACT_OUT_OF_MEMORY) throw std::bad_alloc();
  if (error.status() == PINBALL_CONTACT_FAILED) throw RunError(error.what());
  throw InputError(error.what());
}

std::string text_of(const py::object& object) { return py::str(object); }

py::array array_of(const py::object& given) {
  return py::module_::import("numpy").attr("asarray")(given).cast<py::array>();
}

/// Three components per node, where they lie.
struct Vectors {
  char *x, *y, *z;
  std::int64_t stride;
};

/// pinball.Contact. It keeps the arrays that the library keeps, and those of a step until the next one.
class ContactObject {
 public:
  ContactObject(const py::array& position, const py::object& mass, const Maybe& corners, const Maybe& body,
                const Maybe& bulk_modulus, const Maybe& part, const Maybe& element_mass, const Maybe& element_volume,
                const Maybe& hidden_faces, const Maybe& sphere_node, const Maybe& sphere_radius,
                const Maybe& sphere_bulk_modulus, const Maybe& sphere_body, const Maybe& held_node,
                const Maybe& held_direction, const py::kwargs& given)
      : number_(position.dtype()), nodes_(position.ndim() == 2 ? position.shape(0) : 0) {
    pinball_contact_options options = options_of(given);
    options.number = number_of(position);
    const Maybe& index = corners ? corners : sphere_node;
    if (index && array_of(*index).dtype().equal(py::dtype::of<std::int64_t>())) index_ = py::dtype::of<std::int64_t>();
    options.index = index_.itemsize() == 8 ? PINBALL_CONTACT_INT64 : PINBALL_CONTACT_INT32;
    const auto body_type = py::dtype::of<std::int32_t>();
    pinball_contact_mesh mesh = contact_mesh();
    mesh.node_count = nodes_;
    mesh.mass = kept("mass", mass, number_, nodes_);
    mesh.element_count = count_of(corners);
    const std::int64_t elements = mesh.element_count;
    mesh.corners = kept("corners", corners, index_, 8 * elements);
    mesh.body = static_cast<const std::int32_t*>(kept("body", body, body_type, elements));
    mesh.part = static_cast<const std::int32_t*>(kept("part", part, body_type, elements));
    mesh.part_count = part ? count_of(bulk_modulus) : 0;
    mesh.bulk_modulus = kept("bulk_modulus", bulk_modulus, number_, part ? mesh.part_count : elements);
    mesh.element_mass = kept("element_mass", element_mass, number_, elements);
    mesh.element_volume = kept("element_volume", element_volume, number_, elements);
    mesh.hidden_faces =
        static_cast<const std::uint8_t*>(kept("hidden_faces", hidden_faces, py::dtype::of<std::uint8_t>(), elements));
    mesh.sphere_count = spheres_ = count_of(sphere_node);
    mesh.sphere_node = kept("sphere_node", sphere_node, index_, spheres_);
    mesh.sphere_radius = kept("sphere_radius", sphere_radius, number_, spheres_);
    mesh.sphere_bulk_modulus = kept("sphere_bulk_modulus", sphere_bulk_modulus, number_, spheres_);
    mesh.sphere_body = static_cast<const std::int32_t*>(kept("sphere_body", sphere_body, body_type, spheres_));
    mesh.held_count = count_of(held_node);
    mesh.held_node = kept("held_node", held_node, index_, mesh.held_count);
    mesh.held_direction = kept("held_direction", held_direction, number_, 3 * mesh.held_count);
    elements_ = elements;
    const Vectors at = vectors("position", position);
    call([&] { contact_.emplace(options, mesh, pinball_contact_input{at.x, at.y, at.z, at.stride}); });
  }

  void update(const py::array& position, const py::array& velocity, double dt_before, const Maybe& alive,
              const Maybe& sphere_alive) {
    require_free();
    pinball_contact_arrays arrays = contact_arrays();
    const Vectors x = vectors("position", position), v = vectors("velocity", velocity);
    arrays.position = {x.x, x.y, x.z, x.stride};
    arrays.velocity = {v.x, v.y, v.z, v.stride};
    std::vector<py::array> of_step{position, velocity};
    const auto flags = py::dtype::of<std::uint8_t>();
    arrays.alive = static_cast<const std::uint8_t*>(taken(of_step, "alive", alive, flags, elements_));
    arrays.sphere_alive =
        static_cast<const std::uint8_t*>(taken(of_step, "sphere_alive", sphere_alive, flags, spheres_));
    // The force is not looked at here, but has to be somewhere.
    arrays.force = {x.x, x.y, x.z, x.stride};
    call([&] { contact_->update(arrays, dt_before); });
    arrays_ = arrays;
    of_step_ = std::move(of_step);
  }

  pinball_contact_result add_forces(const py::array& force, double dt_after) {
    require_free();
    if (!arrays_) throw InputError("add_forces: expected a call of update before");
    const Vectors f = vectors("force", force);
    if (!force.writeable()) throw InputError("force: expected an array that can be written");
    arrays_->force = {f.x, f.y, f.z, f.stride};
    pinball_contact_result result{};
    call([&] { result = contact_->add_forces(*arrays_, dt_after); });
    return result;
  }

 private:
  static std::int32_t number_of(const py::array& position) {
    if (position.dtype().equal(py::dtype::of<double>())) return PINBALL_CONTACT_DOUBLE;
    if (position.dtype().equal(py::dtype::of<float>())) return PINBALL_CONTACT_FLOAT;
    throw InputError("position: expected numbers of float64 or float32, got " + text_of(position.dtype()));
  }
  static std::int64_t count_of(const Maybe& array) { return array ? static_cast<std::int64_t>(py::len(*array)) : 0; }

  /// Used where it lies if it is of the type and without gaps, else a copy of it.
  static const void* taken(std::vector<py::array>& keep, const char* name, const Maybe& given, const py::dtype& type,
                           std::int64_t size) {
    if (!given) return nullptr;
    const py::array there = array_of(*given);
    const std::string_view taken_kinds = type.kind() == 'f' ? "fiub" : "iub";
    if (there.size() > 0 && taken_kinds.find(there.dtype().kind()) == std::string_view::npos) {
      throw InputError(std::string(name) + ": expected " + (type.kind() == 'f' ? "" : "whole ") + "numbers, got " +
                       text_of(there.dtype()));
    }
    // By their values: numbers of Python are of 64 bits with a sign, whatever they are.
    const py::object made =
        there.attr("astype")(type, py::arg("order") = "C", py::arg("casting") = "unsafe", py::arg("copy") = false);
    if (!made.is(there) && type.kind() != 'f' && !there.attr("__eq__")(made).attr("all")().cast<bool>()) {
      throw InputError(std::string(name) + ": expected numbers that " + text_of(type) + " can hold");
    }
    keep.push_back(made.cast<py::array>());
    if (keep.back().size() != size) {
      throw InputError(std::string(name) + ": expected " + std::to_string(size) + " numbers, got " +
                       std::to_string(keep.back().size()));
    }
    return keep.back().data();
  }
  const void* kept(const char* name, const Maybe& given, const py::dtype& type, std::int64_t size) {
    return taken(kept_, name, given, type, size);
  }

  /// Never copied: it is read or written where it lies.
  Vectors vectors(const std::string& name, const py::array& array) const {
    if (!array.dtype().equal(number_)) {
      throw InputError(name + ": expected numbers of " + text_of(number_) + ", got " + text_of(array.dtype()));
    }
    if (array.ndim() != 2 || array.shape(0) != nodes_ || array.shape(1) != 3) {
      throw InputError(name + ": expected an array of shape (" + std::to_string(nodes_) + ", 3), got " +
                       text_of(array.attr("shape")));
    }
    if (array.strides(0) % array.itemsize() != 0) {
      throw InputError(name + ": expected nodes at a distance of whole numbers");
    }
    char* const first = static_cast<char*>(const_cast<void*>(array.data()));
    const py::ssize_t component = array.strides(1);
    return {first, first + component, first + 2 * component, array.strides(0) / array.itemsize()};
  }

  void require_free() const {
    if (busy_)
      throw std::runtime_error("Contact: another thread is in a call of it; it is used by one thread at a time");
  }
  template <class Call>
  void call(const Call& what) {
    busy_ = true;
    struct End {
      bool& busy;
      ~End() { busy = false; }
    } const end{busy_};
    try {
      without_lock(what);
    } catch (const EmbeddedContactError& error) {
      throw_python(error);
    }
  }

  py::dtype number_, index_{py::dtype::of<std::int32_t>()};
  std::int64_t nodes_, elements_ = 0, spheres_ = 0;
  bool busy_ = false;
  std::vector<py::array> kept_, of_step_;
  std::optional<pinball_contact_arrays> arrays_;
  std::optional<EmbeddedContact> contact_;
};

void bind_result(py::module_& module) {
  using Result = pinball_contact_result;
  DataClass<Result>(module, "ContactResult", "What contact has done in a step.")
      .def_readonly("stored", &Result::stored, "energy in the penalty springs now [energy]")
      .def_readonly("dissipated", &Result::dissipated, "since creation [energy]")
      .def_readonly("eroded", &Result::eroded, "of springs that went with elements, since creation [energy]")
      .def_readonly("damped_power", &Result::damped_power, "of the damping now [power]")
      .def_readonly("penetration_ratio", &Result::penetration_ratio, "largest, over the size of its pair [-]")
      .def_readonly("pairs", &Result::pairs, "that push")
      .def_readonly("listed_pairs", &Result::listed_pairs, "that are looked at in each step")
      .def_readonly("surface_elements", &Result::surface_elements, "elements and spheres with an exposed face")
      .def_readonly("searches", &Result::searches, "since creation")
      .def_readonly("searches_skipped", &Result::searches_skipped, "steps whose lists still held")
      .def_readonly("frequency2", &Result::frequency2, "bound on the square of the contact frequency [1/time^2]")
      .def_readonly("stable_step", &Result::stable_step, "2 / sqrt(frequency2) [time]");
}

}  // namespace

void bind_contact(py::module_& module) {
  bind_result(module);
  const py::none none;
  py::class_<ContactObject>(
      module, "Contact",
      "Pinball contact in a time loop of the caller's (contact.h, docs/embedding.md): each step one "
      "update() and one add_forces(). Numbers are all float64 or all float32.")
      .def(py::init<const py::array&, const py::object&, const Maybe&, const Maybe&, const Maybe&, const Maybe&,
                    const Maybe&, const Maybe&, const Maybe&, const Maybe&, const Maybe&, const Maybe&, const Maybe&,
                    const Maybe&, const Maybe&, const py::kwargs&>(),
           py::arg("position"), py::arg("mass"), py::arg("corners") = none, py::arg("body") = none,
           py::arg("bulk_modulus") = none, py::arg("part") = none, py::arg("element_mass") = none,
           py::arg("element_volume") = none, py::arg("hidden_faces") = none, py::arg("sphere_node") = none,
           py::arg("sphere_radius") = none, py::arg("sphere_bulk_modulus") = none, py::arg("sphere_body") = none,
           py::arg("held_node") = none, py::arg("held_direction") = none,
           "position: (nodes, 3), undeformed [length]; mass: (nodes,) [mass]; corners: (elements, 8), int32 or int64; "
           "body, part: (elements,); bulk_modulus: (elements,) or (parts,) [stress]; sphere_*: (spheres,); held_node: "
           "(held,), held_direction: (held, 3). Spheres meet the faces of elements, whatever their radius; with gap = "
           "'pinball' "
           "the balls of elements, between which small ones fall. Options by name: method, enforcement, gap, radius "
           "(texts), beta, "
           "damping, friction, static_friction, radius_factor, skin, self, keep_lists, threads, first_index. Arrays of "
           "the right type without gaps are used where they lie and have to stay unchanged; others are copied.")
      .def("update", &ContactObject::update, py::arg("position"), py::arg("velocity"), py::arg("dt_before"),
           py::arg("alive") = none, py::arg("sphere_alive") = none,
           "position: (nodes, 3) at t_n [length]; velocity: (nodes, 3) in the middle of the last step [length/time]; "
           "dt_before: its length, 0 in the first [time]; alive: (elements,), 0 once eroded. Nothing is copied.")
      .def("add_forces", &ContactObject::add_forces, py::arg("force"), py::arg("dt_after"),
           "Adds to force: (nodes, 3) [force]; dt_after: length of the coming step, 0 in the last [time]. Returns a "
           "ContactResult.");
}

}  // namespace pinball::python
