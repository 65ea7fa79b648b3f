! Pinball contact for Fortran: the C interface of <pinball/contact/contact.h>, name by name; what everything means stands
! there. To be compiled with the host. Pointers to arrays are made with c_loc, so the arrays need the attribute TARGET;
! those that the header calls "kept" have to stay where they are until pinball_contact_destroy.
module pinball_contact
  use, intrinsic :: iso_c_binding
  implicit none
  private

  ! Status
  integer(c_int), parameter, public :: PINBALL_CONTACT_OK = 0, PINBALL_CONTACT_NULL_POINTER = 1, &
    PINBALL_CONTACT_BAD_VERSION = 2, PINBALL_CONTACT_BAD_OPTION = 3, PINBALL_CONTACT_BAD_COUNT = 4, &
    PINBALL_CONTACT_BAD_INDEX = 5, PINBALL_CONTACT_BAD_NUMBER = 6, PINBALL_CONTACT_BAD_MESH = 7, &
    PINBALL_CONTACT_BAD_ORDER = 8, PINBALL_CONTACT_OUT_OF_MEMORY = 9, PINBALL_CONTACT_FAILED = 10
  ! Options
  integer(c_int32_t), parameter, public :: PINBALL_CONTACT_DOUBLE = 0, PINBALL_CONTACT_FLOAT = 1
  integer(c_int32_t), parameter, public :: PINBALL_CONTACT_INT32 = 0, PINBALL_CONTACT_INT64 = 1
  integer(c_int32_t), parameter, public :: PINBALL_CONTACT_PINBALL = 0, PINBALL_CONTACT_SLIDELINE = 1
  integer(c_int32_t), parameter, public :: PINBALL_CONTACT_PENALTY = 0, PINBALL_CONTACT_PROJECTION = 1, &
    PINBALL_CONTACT_LAGRANGE = 2
  integer(c_int32_t), parameter, public :: PINBALL_CONTACT_GAP_PINBALL = 0, PINBALL_CONTACT_GAP_FACE = 1
  integer(c_int32_t), parameter, public :: PINBALL_CONTACT_RADIUS_INITIAL = 0, PINBALL_CONTACT_RADIUS_CURRENT = 1
  integer(c_int32_t), parameter, public :: PINBALL_CONTACT_NOTE = 0, PINBALL_CONTACT_ERROR = 1, &
    PINBALL_CONTACT_WARNING = 2

  type, bind(C), public :: pinball_contact_options
    integer(c_size_t) :: size
    integer(c_int32_t) :: number, index, first_index, method, enforcement, gap, radius, self, keep_lists, threads
    real(c_double) :: beta, damping, friction, static_friction, radius_factor, skin
    type(c_funptr) :: log
    type(c_ptr) :: log_user
    type(c_funptr) :: failed
    type(c_ptr) :: failed_user
  end type

  type, bind(C), public :: pinball_contact_mesh
    integer(c_size_t) :: size
    integer(c_int64_t) :: node_count
    type(c_ptr) :: mass
    integer(c_int64_t) :: element_count
    type(c_ptr) :: corners, body, bulk_modulus, part
    integer(c_int64_t) :: part_count
    type(c_ptr) :: element_mass, element_volume, hidden_faces
    integer(c_int64_t) :: sphere_count
    type(c_ptr) :: sphere_node, sphere_radius, sphere_bulk_modulus, sphere_body
    integer(c_int64_t) :: held_count
    type(c_ptr) :: held_node, held_direction, tile_offsets
    integer(c_int64_t) :: tile_count
  end type

  type, bind(C), public :: pinball_contact_input
    type(c_ptr) :: x, y, z
    integer(c_int64_t) :: stride
  end type

  type, bind(C), public :: pinball_contact_output
    type(c_ptr) :: x, y, z
    integer(c_int64_t) :: stride
  end type

  type, bind(C), public :: pinball_contact_arrays
    integer(c_size_t) :: size
    type(pinball_contact_input) :: position, velocity
    type(pinball_contact_output) :: force
    integer(c_int32_t) :: force_records
    type(c_ptr) :: alive, sphere_alive
  end type

  type, bind(C), public :: pinball_contact_result
    real(c_double) :: stored, dissipated, eroded, damped_power, penetration_ratio
    integer(c_int64_t) :: pairs, listed_pairs, surface_elements, searches, searches_skipped
    real(c_double) :: frequency2, stable_step
  end type

  interface
    subroutine pinball_contact_options_init(options) bind(C)
      import :: pinball_contact_options
      type(pinball_contact_options), intent(out) :: options
    end subroutine

    subroutine pinball_contact_mesh_init(mesh) bind(C)
      import :: pinball_contact_mesh
      type(pinball_contact_mesh), intent(out) :: mesh
    end subroutine

    subroutine pinball_contact_arrays_init(arrays) bind(C)
      import :: pinball_contact_arrays
      type(pinball_contact_arrays), intent(out) :: arrays
    end subroutine

    integer(c_int) function pinball_contact_create(options, mesh, position, contact) bind(C)
      import :: c_int, c_ptr, pinball_contact_options, pinball_contact_mesh, pinball_contact_input
      type(pinball_contact_options), intent(in) :: options
      type(pinball_contact_mesh), intent(in) :: mesh
      type(pinball_contact_input), intent(in) :: position
      type(c_ptr), intent(out) :: contact
    end function

    subroutine pinball_contact_destroy(contact) bind(C)
      import :: c_ptr
      type(c_ptr), value :: contact
    end subroutine

    integer(c_int) function pinball_contact_update(contact, arrays, dt_before) bind(C)
      import :: c_int, c_ptr, c_double, pinball_contact_arrays
      type(c_ptr), value :: contact
      type(pinball_contact_arrays), intent(in) :: arrays
      real(c_double), value :: dt_before
    end function

    integer(c_int) function pinball_contact_add_forces(contact, arrays, dt_after, result) bind(C)
      import :: c_int, c_ptr, c_double, pinball_contact_arrays, pinball_contact_result
      type(c_ptr), value :: contact
      type(pinball_contact_arrays), intent(in) :: arrays
      real(c_double), value :: dt_after
      type(pinball_contact_result), intent(out), optional :: result
    end function
  end interface

  public :: pinball_contact_options_init, pinball_contact_mesh_init, pinball_contact_arrays_init, &
    pinball_contact_create, pinball_contact_destroy, pinball_contact_update, pinball_contact_add_forces, &
    pinball_contact_text, pinball_contact_vectors, pinball_contact_forces

contains

  ! What the last call on an instance failed with: pinball_contact_message as text of Fortran.
  function pinball_contact_text(contact) result(text)
    type(c_ptr), intent(in) :: contact
    character(:), allocatable :: text
    character(kind=c_char), pointer :: characters(:)
    type(c_ptr) :: message
    integer(c_size_t) :: i
    interface
      type(c_ptr) function message_of(contact) bind(C, name='pinball_contact_message')
        import :: c_ptr
        type(c_ptr), value :: contact
      end function
      integer(c_size_t) function length_of(text) bind(C, name='strlen')
        import :: c_ptr, c_size_t
        type(c_ptr), value :: text
      end function
    end interface
    message = message_of(contact)
    call c_f_pointer(message, characters, [length_of(message)])
    allocate (character(size(characters)) :: text)
    do i = 1, size(characters, kind=c_size_t)
      text(i:i) = characters(i)
    end do
  end function

  ! Vectors that lie as x(3, :) or x(4, :) do, or longer ones of which the first three numbers count: also sections, such
  ! as state(4:6, :). Not CONTIGUOUS: what is not would be handed in as a copy, whose address means nothing afterwards.
  function pinball_contact_vectors(x) result(input)
    real(c_double), intent(in), target :: x(:, :)
    type(pinball_contact_input) :: input
    input = pinball_contact_input(c_loc(x(1, 1)), c_loc(x(2, 1)), c_loc(x(3, 1)), numbers_between(x))
  end function

  ! The same for what is added to.
  function pinball_contact_forces(f) result(output)
    real(c_double), intent(inout), target :: f(:, :)
    type(pinball_contact_output) :: output
    output = pinball_contact_output(c_loc(f(1, 1)), c_loc(f(2, 1)), c_loc(f(3, 1)), numbers_between(f))
  end function

  ! From a node to the next one, as they lie.
  integer(c_int64_t) function numbers_between(x)
    real(c_double), intent(in), target :: x(:, :)
    integer(c_intptr_t) :: first, second
    numbers_between = size(x, 1, c_int64_t)
    if (size(x, 2) < 2) return
    first = transfer(c_loc(x(1, 1)), first)
    second = transfer(c_loc(x(1, 2)), second)
    numbers_between = (second - first) / c_sizeof(x(1, 1))
  end function
end module
