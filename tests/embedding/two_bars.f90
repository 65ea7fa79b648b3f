! A host in Fortran with its own mesh and time loop: the two bars of data/scenes/two_bars.toml, each ten cubes of edge 1
! in a row, of which the first strikes the second. A bar is what a row of springs is: along each of its four edges a
! spring per element. Prints what compare.py compares.
program two_bars
  use, intrinsic :: iso_c_binding
  use pinball_contact
  implicit none

  integer, parameter :: bars = 2, elements_of_bar = 10, layers = elements_of_bar + 1
  integer, parameter :: nodes = bars * layers * 4, elements = bars * elements_of_bar
  real(c_double), parameter :: modulus = 100, density = 1, gap = 0.5, end_time = 8

  ! The host's arrays: x, y, z of a node side by side.
  real(c_double), target :: x(3, nodes), v(3, nodes), f(3, nodes), mass(nodes)
  integer(c_int32_t), target :: corners(8, elements), body(elements), part(elements)
  real(c_double), target :: bulk_modulus(1)

  real(c_double), parameter :: dt = 0.05_c_double  ! half of h / c
  integer, parameter :: steps = nint(end_time / dt)
  type(c_ptr) :: contact
  type(pinball_contact_arrays) :: arrays
  type(pinball_contact_result) :: result
  real(c_double) :: before, after, energy
  integer :: step, node

  call make_mesh()
  f = 0
  call begin_contact()
  print '(a, es25.17)', 'momentum_initial', sum(mass * v(1, :)), 'energy_initial', kinetic_energy(0._c_double)

  ! [loop]
  call pinball_contact_arrays_init(arrays)
  arrays%position = pinball_contact_vectors(x)
  arrays%velocity = pinball_contact_vectors(v)
  arrays%force = pinball_contact_forces(f)
  do step = 0, steps
    ! Velocities belong to the middle of a step: the first and the last acceleration are over half a step.
    before = merge(0._c_double, dt, step == 0)
    after = merge(0._c_double, dt, step == steps)

    f = 0
    call add_spring_forces(energy)
    call check(pinball_contact_update(contact, arrays, before))
    call check(pinball_contact_add_forces(contact, arrays, after, result))
    energy = energy + kinetic_energy(before) + result%stored + result%dissipated
    do node = 1, nodes
      v(:, node) = v(:, node) + f(:, node) / mass(node) * (before + after) / 2
      x(:, node) = x(:, node) + v(:, node) * after
    end do
  end do
  ! [loop]
  call pinball_contact_destroy(contact)

  print '(a, es25.17)', 'momentum_final', sum(mass * v(1, :)), &
    'energy_final', energy, 'contact_dissipated', result%dissipated, &
    'velocity_bar1', velocity_of_bar(1), 'velocity_bar2', velocity_of_bar(2)

contains

  ! Contact between the bars, by impulses that solve the coupled system of the step.
  subroutine begin_contact()
    ! [create]
    type(pinball_contact_options) :: options
    type(pinball_contact_mesh) :: mesh

    call pinball_contact_options_init(options)
    options%enforcement = PINBALL_CONTACT_LAGRANGE
    options%first_index = 1
    options%self = 0
    options%radius_factor = 0.8059959770082347_c_double  ! (pi/6)^(1/3): balls touch where the faces of the bars touch

    bulk_modulus(1) = modulus / 3  ! without Poisson effect
    part = 0
    call pinball_contact_mesh_init(mesh)
    mesh%node_count = nodes
    mesh%mass = c_loc(mass)
    mesh%element_count = elements
    mesh%corners = c_loc(corners)
    mesh%body = c_loc(body)
    mesh%bulk_modulus = c_loc(bulk_modulus)
    mesh%part = c_loc(part)
    mesh%part_count = 1
    call check(pinball_contact_create(options, mesh, pinball_contact_vectors(x), contact))
    ! [create]

    ! The types of the module are those of the header.
    if (options%size /= c_sizeof(options) .or. mesh%size /= c_sizeof(mesh)) error stop 'other types than in C'
  end subroutine

  subroutine check(status)
    integer(c_int), intent(in) :: status
    if (status == PINBALL_CONTACT_OK) return
    print '(a)', 'contact: ' // pinball_contact_text(contact)
    error stop 1
  end subroutine

  ! Of the velocities half a step before t_n and after it: what it changes by is the work of the forces, exactly.
  real(c_double) function kinetic_energy(time_step)
    real(c_double), intent(in) :: time_step
    kinetic_energy = (sum(mass * sum(v**2, 1)) + sum(v * f) * time_step) / 2
  end function

  real(c_double) function velocity_of_bar(bar)
    integer, intent(in) :: bar
    integer :: first, last
    first = (bar - 1) * layers * 4 + 1
    last = bar * layers * 4
    velocity_of_bar = sum(mass(first:last) * v(1, first:last)) / sum(mass(first:last))
  end function

  subroutine make_mesh()
    integer :: bar, layer, corner, node, element
    mass = 0
    v = 0
    do bar = 1, bars
      do layer = 1, layers
        do corner = 1, 4
          node = ((bar - 1) * layers + layer - 1) * 4 + corner
          x(1, node) = (bar - 1) * (elements_of_bar + gap) + layer - 1
          x(2, node) = merge(1, 0, corner == 2 .or. corner == 3)
          x(3, node) = merge(1, 0, corner == 3 .or. corner == 4)
          if (bar == 1) v(1, node) = 0.1_c_double
        end do
      end do
      do layer = 1, elements_of_bar
        element = (bar - 1) * elements_of_bar + layer
        body(element) = bar - 1
        do corner = 1, 8
          node = ((bar - 1) * layers + layer - 1) * 4 + corner
          corners(corner, element) = node
          mass(node) = mass(node) + density / 8
        end do
      end do
    end do
  end subroutine

  ! Forces of the springs along x, and their energy.
  subroutine add_spring_forces(energy)
    real(c_double), intent(out) :: energy
    real(c_double), parameter :: stiffness = modulus / 4
    real(c_double) :: stretch
    integer :: element, edge, left, right
    energy = 0
    do element = 1, elements
      do edge = 1, 4
        left = corners(edge, element)
        right = corners(edge + 4, element)
        stretch = x(1, right) - x(1, left) - 1
        f(1, left) = f(1, left) + stiffness * stretch
        f(1, right) = f(1, right) - stiffness * stretch
        energy = energy + stiffness * stretch**2 / 2
      end do
    end do
  end subroutine
end program
