/**
 * @file
 * Pinball contact in a host's own explicit time loop: the C interface. `<pinball/contact/embedded_contact.hpp>` wraps it
 * for C++. The code behind it is the one that Pinball's own solver runs: on the same state both give the same bits.
 *
 * **Life of a step.** The host integrates with central differences: positions belong to t_n, velocities to the middle of
 * the last step, forces to t_n. Between pinball_contact_create and pinball_contact_destroy each step is
 *
 *  1. clear the nodal forces and add the internal ones;
 *  2. pinball_contact_update: takes in positions, velocities and alive flags, searches when the lists of what may touch
 *     no longer hold, and computes what follows from these: the forces of springs, or the constraints of impulses;
 *  3. with PINBALL_CONTACT_PENALTY: pinball_contact_add_forces, whose `frequency2` bounds the coming step together with
 *     the elements'; then choose that step, add loads and apply constraints.
 *     With PINBALL_CONTACT_PROJECTION or PINBALL_CONTACT_LAGRANGE: choose the coming step (the contact does not bound
 *     it), add loads and apply constraints and prescribed velocities to forces and velocities, and then
 *     pinball_contact_add_forces: its forces keep gaps from closing within that step, given all other forces. What it
 *     adds in constrained directions the constraints take up again;
 *  4. accelerate by force / mass over the mean of the steps before and after, and move.
 *
 * Each update is followed by exactly one pinball_contact_add_forces.
 *
 * **Units** are any consistent set. **Numbers** of one instance are all double or all float. Those that contact reads of
 * positions, velocities and forces are finite, and so are their squares: this is checked where they are read. **Indices** of nodes count
 * from `first_index`. **Bodies**: nodes of different bodies may touch; nodes of one body do where they were well apart in
 * the undeformed mesh (option `self`), and so do those of bodies that hang together by common nodes. Elements and spheres
 * with a common node never touch.
 *
 * **Ownership.** The host owns all arrays. Those of pinball_contact_mesh marked "kept" are read again whenever an
 * element comes to the surface: they stay where they are, unchanged, until pinball_contact_destroy. All others are read
 * during the call only. Nothing but the force array is written to, and that only by pinball_contact_add_forces, in the
 * first three numbers of nodes in contact (see `force_records`). A call that fails with an error of arguments writes to
 * no array of the host.
 *
 * **Copies.** Positions and velocities that lie in records of four (see pinball_contact_input) are used in place. Of
 * other layouts the nodes of the surface are gathered into such records, once in a step; memory for these is that of
 * 4 numbers per node and array. Undeformed places are kept too, 3 numbers per node.
 *
 * **Threads.** They are OpenMP's, as many as it would take in the thread that calls or as the option `threads` says.
 * There is no global state: calls on different instances may run at the same
 * time; calls on one instance may not. **Determinism**: results do not depend on the number of threads, on what other
 * instances do, or on the layout of the arrays.
 *
 * **Errors.** Functions return a pinball_contact_status; pinball_contact_message tells the argument, and its index (from
 * 0). After an error of arguments the instance is as before the call. No exception leaves these functions, and nothing
 * here writes files or to the terminal or ends the program.
 */
#ifndef PINBALL_CONTACT_H
#define PINBALL_CONTACT_H

#include "../base/export.h"
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** One contact problem: its settings, surface, lists and memory from step to step. */
typedef struct pinball_contact pinball_contact;

/** What a call has come to. */
enum pinball_contact_status {
  PINBALL_CONTACT_OK = 0,
  PINBALL_CONTACT_NULL_POINTER = 1,  /**< a pointer that is required is null */
  PINBALL_CONTACT_BAD_VERSION = 2,   /**< `size` of a struct is not one that this library knows: call its init function */
  PINBALL_CONTACT_BAD_OPTION = 3,    /**< an option has no such value, or does not go with another */
  PINBALL_CONTACT_BAD_COUNT = 4,     /**< a count or a stride that cannot be */
  PINBALL_CONTACT_BAD_INDEX = 5,     /**< an index out of range */
  PINBALL_CONTACT_BAD_NUMBER = 6,    /**< see "Numbers"; or a mass, volume, radius or modulus that is not positive */
  PINBALL_CONTACT_BAD_MESH = 7,      /**< elements that cannot be neighbours: three at one face, two the same */
  PINBALL_CONTACT_BAD_ORDER = 8,     /**< a call out of its turn in the step */
  PINBALL_CONTACT_OUT_OF_MEMORY = 9, /**< an instance that was made is of no use any more, but for its message */
  PINBALL_CONTACT_FAILED = 10        /**< an internal check failed: the instance is of no use any more */
};

/** Type of the numbers in arrays. */
enum pinball_contact_number { PINBALL_CONTACT_DOUBLE = 0, PINBALL_CONTACT_FLOAT = 1 };
/** Type of node numbers. */
enum pinball_contact_index { PINBALL_CONTACT_INT32 = 0, PINBALL_CONTACT_INT64 = 1 };
/** Balls in surface elements (Belytschko, Liu and Neal 1990), or slave nodes against master faces. */
enum pinball_contact_method { PINBALL_CONTACT_PINBALL = 0, PINBALL_CONTACT_SLIDELINE = 1 };
/** Springs; or impulses: one step towards the solution of the coupled system of the step, or that solution. */
enum pinball_contact_enforcement {
  PINBALL_CONTACT_PENALTY = 0,
  PINBALL_CONTACT_PROJECTION = 1,
  PINBALL_CONTACT_LAGRANGE = 2
};
/** What impulses keep from closing: the distance of balls, or that of the faces that look at each other. With springs:
 * whether spheres meet the balls of elements, between which small ones fall, or their faces. */
enum pinball_contact_gap { PINBALL_CONTACT_GAP_PINBALL = 0, PINBALL_CONTACT_GAP_FACE = 1 };
/** Radii of balls: of the undeformed elements, or of their present volumes. */
enum pinball_contact_radius { PINBALL_CONTACT_RADIUS_INITIAL = 0, PINBALL_CONTACT_RADIUS_CURRENT = 1 };
/** What a message is about. */
enum pinball_contact_log_level { PINBALL_CONTACT_NOTE = 0, PINBALL_CONTACT_ERROR = 1, PINBALL_CONTACT_WARNING = 2 };

/** Called with what an instance has to say; message: valid during the call only. It returns: what it throws goes no further. */
typedef void (*pinball_contact_log_hook)(void *user, int level, const char *message);
/** Called with an internal check that failed, before the call returns PINBALL_CONTACT_FAILED. It may end the program;
 * what it throws goes no further. */
typedef void (*pinball_contact_assert_hook)(void *user, const char *expression, const char *file, int line);

/** Settings of an instance. To be filled by pinball_contact_options_init first. */
typedef struct pinball_contact_options {
  size_t size;             /**< of this struct: its version */
  int32_t number;          /**< pinball_contact_number of all arrays; PINBALL_CONTACT_DOUBLE */
  int32_t index;           /**< pinball_contact_index of node numbers; PINBALL_CONTACT_INT32 */
  int32_t first_index;     /**< number of the first node: 0, or 1 as in Fortran; 0 */
  int32_t method;          /**< pinball_contact_method; PINBALL_CONTACT_PINBALL */
  int32_t enforcement;     /**< pinball_contact_enforcement; PINBALL_CONTACT_PENALTY */
  int32_t gap;             /**< pinball_contact_gap, of pinballs; PINBALL_CONTACT_GAP_FACE */
  int32_t radius;          /**< pinball_contact_radius; PINBALL_CONTACT_RADIUS_INITIAL, without which no spheres */
  int32_t self;            /**< 1: a body may touch itself; 1 */
  int32_t keep_lists;      /**< 1: lists of what may touch serve many steps, with the same results; 1 */
  int32_t threads;         /**< 0: as many as OpenMP would take in the calling thread; else this many, up to 4096; 0 */
  double beta;             /**< penalty factor, > 0 [-]; 1 */
  double damping;          /**< of the springs, as a part of critical damping, >= 0 [-]; 0.1 */
  double friction;         /**< Coulomb coefficient while sliding, >= 0, with impulses only [-]; 0 */
  double static_friction;  /**< the same at rest, >= friction; negative: as friction [-]; -1 */
  double radius_factor;    /**< on the radii of the balls of elements, > 0 [-]; 1 */
  double skin;             /**< how far a node may stray before a search, over its radius, > 0 [-]; 0.5 */
  pinball_contact_log_hook log;        /**< null: nobody is informed; null */
  void *log_user;                      /**< handed to log */
  pinball_contact_assert_hook failed;  /**< null: nobody is informed; null */
  void *failed_user;                   /**< handed to failed */
} pinball_contact_options;

/** What takes part in contact. To be filled by pinball_contact_mesh_init first. "Numbers" are of the type that the
 * options name, and so are "node numbers". */
typedef struct pinball_contact_mesh {
  size_t size;           /**< of this struct: its version */
  int64_t node_count;    /**< nodes of the host, up to 2^31 - 2; those of no element and no sphere are never read */
  const void *mass;      /**< numbers, one per node, > 0 where an element or sphere has the node [mass] */
  /** Hexahedra: 0 or more. */
  int64_t element_count;
  /** Kept. Node numbers, 8 per element, one element after the other: 0-3 counterclockwise around the bottom seen from
   * the top, 4-7 above them. Elements may be collapsed: a node may stand at two ends of an edge. */
  const void *corners;
  const int32_t *body;   /**< kept; per element its body, 0 ... 2^24 - 1; null: all are of body 0 */
  /** Kept. Numbers, > 0 [stress]: per element, or per part where `part` is given. */
  const void *bulk_modulus;
  const int32_t *part;   /**< kept; per element its place in bulk_modulus; null: bulk_modulus is per element */
  int64_t part_count;    /**< entries of bulk_modulus where `part` is given */
  const void *element_mass;    /**< kept; numbers, > 0 [mass]; null: equal shares of the mass of each node */
  const void *element_volume;  /**< kept; undeformed, numbers, > 0 [length^3]; null: that of the positions at creation */
  /** Per element bits of faces that are not to touch although they have no neighbour, as in a plane of symmetry; null:
   * none. Bits 0-5: the faces of corners 0374, 1265, 0154, 2376, 0321, 4567. */
  const uint8_t *hidden_faces;
  /** Rigid spheres and particles: 0 or more. With PINBALL_CONTACT_SLIDELINE none. */
  int64_t sphere_count;
  const void *sphere_node;          /**< kept; node numbers of their centres, which may belong to no element */
  const void *sphere_radius;        /**< kept; numbers, > 0 [length] */
  const void *sphere_bulk_modulus;  /**< kept; numbers, > 0 [stress] */
  const int32_t *sphere_body;       /**< kept; null: each is a body of its own, and they touch each other */
  /** Directions in which nodes cannot move, for impulses: 0 or more. */
  int64_t held_count;
  const void *held_node;       /**< node numbers */
  const void *held_direction;  /**< numbers, 3 per entry: of unit length, those of one node orthogonal [-] */
  /** How consecutive elements are taken together for work in parallel: first element of each tile, ascending from 0, and
   * at last element_count; tile_count + 1 entries. Null: they are cut here. It decides the order in which forces are
   * added, to the last bit. */
  const int64_t *tile_offsets;
  int64_t tile_count; /**< tiles of tile_offsets */
} pinball_contact_mesh;

/** One vector per node: pointers to the components of the first node, and the distance from one node to the next in
 * numbers. Interleaved: x, x + 1, x + 2 and stride 3. Three arrays: their beginnings and stride 1. Positions and
 * velocities with x, x + 1, x + 2 and stride 4, aligned to four numbers, are records of four, which are used in place:
 * the fourth number of each node must be readable. */
typedef struct pinball_contact_input {
  const void *x;  /**< first component of the first node */
  const void *y;  /**< second component */
  const void *z;  /**< third component */
  int64_t stride; /**< numbers from one node to the next */
} pinball_contact_input;

/** The same for what is added to. */
typedef struct pinball_contact_output {
  void *x;        /**< first component of the first node */
  void *y;        /**< second component */
  void *z;        /**< third component */
  int64_t stride; /**< numbers from one node to the next */
} pinball_contact_output;

/** The host's arrays in a step. To be filled by pinball_contact_arrays_init first; the same for both calls of a step. */
typedef struct pinball_contact_arrays {
  size_t size;                     /**< of this struct: its version */
  pinball_contact_input position;  /**< at t_n [length] */
  pinball_contact_input velocity;  /**< in the middle of the last step [length/time] */
  pinball_contact_output force;    /**< at t_n [force]; pinball_contact_update leaves it alone */
  /** 1: the forces are records of four as above, whose fourth number is free: it is zero when pinball_contact_add_forces
   * is called, and holds a contact stiffness afterwards. Then they are used in place; 0. */
  int32_t force_records;
  /** Per element: 0 eroded, 1 alive, 2 alive, but may erode within some steps (a guess that saves searches). What has
   * eroded does not come back. Null: all are alive. */
  const uint8_t *alive;
  const uint8_t *sphere_alive;  /**< the same per sphere */
} pinball_contact_arrays;

/** What pinball_contact_add_forces tells. */
typedef struct pinball_contact_result {
  double stored;             /**< energy in the penalty springs now [energy] */
  double dissipated;         /**< by damping, impulses, friction and contacts that jumped, since creation [energy] */
  double eroded;             /**< of springs that went with eroded elements, since creation [energy] */
  double damped_power;       /**< power of the damping now, which `dissipated` sums by the trapezoidal rule [power] */
  double penetration_ratio;  /**< largest penetration over the size of its pair, R1 + R2 [-] */
  int64_t pairs;             /**< pairs that push */
  int64_t listed_pairs;      /**< pairs that are looked at in each step */
  int64_t surface_elements;  /**< elements and spheres with an exposed face */
  int64_t searches;          /**< since creation */
  int64_t searches_skipped;  /**< steps since creation whose lists still held */
  /** Bound on the square of the contact frequency; 0 with impulses [1/time^2]. With elements stable up to the step h,
   * all is stable up to 2 / sqrt(4 / h^2 + frequency2), of which a host takes a part, 0.9. */
  double frequency2;
  double stable_step;        /**< 2 / sqrt(frequency2), infinite without contact [time] */
} pinball_contact_result;

/** Fills in the defaults that are named above, after the semicolons. Null is let be. */
PINBALL_API void pinball_contact_options_init(pinball_contact_options *options);
/** Empty: no nodes, elements, spheres or held directions. Null is let be. */
PINBALL_API void pinball_contact_mesh_init(pinball_contact_mesh *mesh);
/** Empty: no arrays. Null is let be. */
PINBALL_API void pinball_contact_arrays_init(pinball_contact_arrays *arrays);

/**
 * Makes an instance.
 * @param options, mesh  read during the call; see "kept" above for what their pointers point to
 * @param position       of all nodes, undeformed [length]: what may touch its own body is decided by it
 * @param contact        receives the instance; after an error one that is only good for pinball_contact_message and
 *                       pinball_contact_destroy, or null where there is no memory or `contact` itself is null
 */
PINBALL_API int pinball_contact_create(const pinball_contact_options *options, const pinball_contact_mesh *mesh,
                                               const pinball_contact_input *position, pinball_contact **contact);
/** Frees an instance. Null is let be. */
PINBALL_API void pinball_contact_destroy(pinball_contact *contact);

/**
 * Takes in where everything is, and searches when needed.
 * @param dt_before  length of the step just made, from t_(n-1) to t_n; 0 in the first [time]. What may touch is looked
 *                   for as far as it closes in a step of twice this length, and once more in
 *                   pinball_contact_add_forces where the coming one is longer
 */
PINBALL_API int pinball_contact_update(pinball_contact *contact, const pinball_contact_arrays *arrays,
                                               double dt_before);
/**
 * Adds the contact forces to the force array.
 * @param dt_after  length of the coming step; 0 in the last, which only completes the velocities. Springs do not ask for
 *                  it [time]
 * @param result    written unless the call fails; may be null
 */
PINBALL_API int pinball_contact_add_forces(pinball_contact *contact, const pinball_contact_arrays *arrays,
                                                   double dt_after, pinball_contact_result *result);

/** What the last call on this instance failed with; "" if it did not. Of a creation that went well: what it warns of,
 * such as spheres that may fall between the balls of elements, and "" where there is nothing. Valid until the next call
 * on it. */
PINBALL_API const char *pinball_contact_message(const pinball_contact *contact);

#ifdef __cplusplus
}
#endif

#endif
