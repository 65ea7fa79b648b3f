! Vectors that are sections of a host's larger arrays: they are read and written where they lie. Two cubes that overlap
! push each other, with the same forces however the arrays lie.
program array_sections
  use, intrinsic :: iso_c_binding
  use pinball_contact
  implicit none

  integer, parameter :: nodes = 16
  real(c_double), target :: state(9, nodes), x(3, nodes), v(3, nodes), f(3, nodes)
  real(c_double), target :: sparse(4, 2 * nodes), mass(nodes), bulk_modulus(2)
  integer(c_int32_t), target :: corners(8, 2), body(2)
  real(c_double), pointer :: of_state(:, :)

  call make_mesh()
  call contact_forces(pinball_contact_vectors(x), pinball_contact_vectors(v), pinball_contact_forces(f))
  if (.not. any(abs(f) > 0)) error stop 'the cubes do not push each other'

  ! Places, velocities and forces side by side.
  state = 0
  state(1:3, :) = x
  state(4:6, :) = v
  of_state => state(7:9, :)
  call contact_forces(pinball_contact_vectors(state(1:3, :)), pinball_contact_vectors(state(4:6, :)), &
                      pinball_contact_forces(of_state))
  if (any(abs(state(7:9, :) - f) > 0)) error stop 'other forces in sections of one array'
  if (any(abs(state(1:3, :) - x) > 0)) error stop 'places have changed'

  ! Every second column, and the forces in rows that lie apart, the last one first.
  state = 0
  sparse = 0
  sparse(1:3, 2:2 * nodes:2) = x
  call contact_forces(pinball_contact_vectors(sparse(1:3, 2:2 * nodes:2)), pinball_contact_vectors(v), &
                      pinball_contact_forces(state(9:3:-3, :)))
  if (any(abs(state(9:3:-3, :) - f) > 0)) error stop 'other forces of columns that lie apart'

  print '(a)', 'sections are taken where they lie'

contains

  subroutine contact_forces(position, velocity, force)
    type(pinball_contact_input), intent(in) :: position, velocity
    type(pinball_contact_output), intent(in) :: force
    type(pinball_contact_options) :: options
    type(pinball_contact_mesh) :: mesh
    type(pinball_contact_arrays) :: arrays
    type(c_ptr) :: contact

    call pinball_contact_options_init(options)
    options%first_index = 1
    call pinball_contact_mesh_init(mesh)
    mesh%node_count = nodes
    mesh%mass = c_loc(mass)
    mesh%element_count = 2
    mesh%corners = c_loc(corners)
    mesh%body = c_loc(body)
    mesh%bulk_modulus = c_loc(bulk_modulus)
    call check(pinball_contact_create(options, mesh, position, contact))
    call pinball_contact_arrays_init(arrays)
    arrays%position = position
    arrays%velocity = velocity
    arrays%force = force
    call check(pinball_contact_update(contact, arrays, 0.001_c_double))
    call check(pinball_contact_add_forces(contact, arrays, 0.001_c_double))
    call pinball_contact_destroy(contact)
  end subroutine

  subroutine check(status)
    integer(c_int), intent(in) :: status
    if (status == PINBALL_CONTACT_OK) return
    print '(a, i0)', 'contact: status ', status
    error stop 1
  end subroutine

  subroutine make_mesh()
    integer :: cube, corner, node
    do cube = 1, 2
      do corner = 1, 8
        node = 8 * (cube - 1) + corner
        corners(corner, cube) = node
        x(1, node) = merge(1, 0, any(modulo(corner, 4) == [2, 3]))
        x(2, node) = merge(1, 0, any(modulo(corner, 4) == [3, 0]))
        x(3, node) = merge(1, 0, corner > 4) + 0.9_c_double * (cube - 1)
      end do
      body(cube) = cube - 1
    end do
    v = 0
    v(3, 9:) = -1
    f = 0
    mass = 1
    bulk_modulus = 100
  end subroutine
end program
