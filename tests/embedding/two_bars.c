/* A host in C with its own mesh and time loop: the two bars of data/scenes/two_bars.toml, each ten cubes of edge 1 in a
 * row, of which the first strikes the second. A bar is what a row of springs is: along each of its four edges a spring
 * per element. Pinball is given the hexahedra, and pointers to the arrays. Prints what compare.py compares. */
#include <pinball/contact/contact.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
  bars = 2,
  elements_of_bar = 10,
  layers = elements_of_bar + 1,
  node_count = bars * layers * 4,
  element_count = bars * elements_of_bar
};

static const double modulus = 100.0, density = 1.0, gap = 0.5, end_time = 8.0, dt = 0.05; /* half of h / c */

/* The host's arrays: coordinates apart from each other. */
static double x[node_count], y[node_count], z[node_count];
static double vx[node_count], vy[node_count], vz[node_count];
static double fx[node_count], fy[node_count], fz[node_count];
static double mass[node_count];
static int32_t corners[element_count][8];
static int32_t body[element_count];

static void make_mesh(void) {
  for (int bar = 0; bar < bars; ++bar) {
    for (int layer = 0; layer < layers; ++layer) {
      for (int corner = 0; corner < 4; ++corner) {
        const int node = (bar * layers + layer) * 4 + corner;
        x[node] = bar * (elements_of_bar + gap) + layer;
        y[node] = corner == 1 || corner == 2;
        z[node] = corner == 2 || corner == 3;
        vx[node] = bar == 0 ? 0.1 : 0.0;
      }
    }
    for (int i = 0; i < elements_of_bar; ++i) {
      const int first = (bar * layers + i) * 4;
      body[bar * elements_of_bar + i] = bar;
      for (int corner = 0; corner < 8; ++corner) {
        corners[bar * elements_of_bar + i][corner] = first + corner;
        mass[first + corner] += density / 8;
      }
    }
  }
}

/* Forces of the springs along x; returns their energy. */
static double add_spring_forces(void) {
  const double stiffness = modulus / 4;
  double energy = 0;
  for (int e = 0; e < element_count; ++e) {
    for (int edge = 0; edge < 4; ++edge) {
      const int left = corners[e][edge], right = corners[e][edge + 4];
      const double stretch = x[right] - x[left] - 1.0;
      fx[left] += stiffness * stretch;
      fx[right] -= stiffness * stretch;
      energy += 0.5 * stiffness * stretch * stretch;
    }
  }
  return energy;
}

/* Contact between the bars. Ends the program on an error, which only a host may do. */
static pinball_contact *begin_contact(void) {
  /* [create] */
  /* Kept by the instance, as are corners and body: not on the stack. */
  static double bulk_modulus[1];
  static const int32_t part[element_count]; /* all of part 0 */
  bulk_modulus[0] = modulus / 3;            /* without Poisson effect */

  pinball_contact_options options;
  pinball_contact_options_init(&options);
  options.beta = 3;
  options.radius_factor = 0.8059959770082347; /* (pi/6)^(1/3): balls touch where the faces of the bars touch */
  options.self = 0;

  pinball_contact_mesh mesh;
  pinball_contact_mesh_init(&mesh);
  mesh.node_count = node_count;
  mesh.mass = mass;
  mesh.element_count = element_count;
  mesh.corners = corners;
  mesh.body = body;
  mesh.bulk_modulus = bulk_modulus;
  mesh.part = part;
  mesh.part_count = 1;

  const pinball_contact_input position = {x, y, z, 1};
  pinball_contact *contact = NULL;
  if (pinball_contact_create(&options, &mesh, &position, &contact) != PINBALL_CONTACT_OK) {
    fprintf(stderr, "contact: %s\n", pinball_contact_message(contact));
    pinball_contact_destroy(contact);
    exit(1);
  }
  /* [create] */
  return contact;
}

static void check(int status, const pinball_contact *contact) {
  if (status == PINBALL_CONTACT_OK) return;
  fprintf(stderr, "contact: %s\n", pinball_contact_message(contact));
  exit(1);
}

static double momentum(int first, int last) {
  double sum = 0;
  for (int i = first; i < last; ++i) sum += mass[i] * vx[i];
  return sum;
}

/* Of the velocities half a step before t_n and after it: what it changes by is the work of the forces, exactly. */
static double kinetic_energy(double step) {
  double sum = 0;
  for (int i = 0; i < node_count; ++i) {
    sum += (vx[i] * (mass[i] * vx[i] + fx[i] * step) + vy[i] * (mass[i] * vy[i] + fy[i] * step) +
            vz[i] * (mass[i] * vz[i] + fz[i] * step)) / 2;
  }
  return sum;
}

int main(void) {
  make_mesh();
  pinball_contact *contact = begin_contact();
  printf("momentum_initial %.17g\n", momentum(0, node_count));
  printf("energy_initial %.17g\n", kinetic_energy(0));

  /* [loop] */
  pinball_contact_arrays arrays;
  pinball_contact_arrays_init(&arrays);
  arrays.position = (pinball_contact_input){x, y, z, 1};
  arrays.velocity = (pinball_contact_input){vx, vy, vz, 1};
  arrays.force = (pinball_contact_output){fx, fy, fz, 1};

  const int steps = (int)(end_time / dt + 0.5);
  double energy = 0;
  pinball_contact_result result;
  for (int step = 0; step <= steps; ++step) {
    /* Velocities belong to the middle of a step: the first and the last acceleration are over half a step. */
    const double before = step == 0 ? 0 : dt, after = step == steps ? 0 : dt;

    memset(fx, 0, sizeof fx);
    memset(fy, 0, sizeof fy);
    memset(fz, 0, sizeof fz);
    energy = add_spring_forces();
    check(pinball_contact_update(contact, &arrays, before), contact);
    check(pinball_contact_add_forces(contact, &arrays, after, &result), contact);
    energy += kinetic_energy(before) + result.stored + result.dissipated;
    for (int i = 0; i < node_count; ++i) {
      vx[i] += fx[i] / mass[i] * (before + after) / 2;
      vy[i] += fy[i] / mass[i] * (before + after) / 2;
      vz[i] += fz[i] / mass[i] * (before + after) / 2;
      x[i] += vx[i] * after;
      y[i] += vy[i] * after;
      z[i] += vz[i] * after;
    }
  }
  /* [loop] */
  pinball_contact_destroy(contact);

  const double bar_mass = elements_of_bar * density;
  printf("momentum_final %.17g\n", momentum(0, node_count));
  printf("energy_final %.17g\n", energy);
  printf("contact_dissipated %.17g\n", result.dissipated);
  printf("velocity_bar1 %.17g\n", momentum(0, node_count / 2) / bar_mass);
  printf("velocity_bar2 %.17g\n", momentum(node_count / 2, node_count) / bar_mass);
  return 0;
}
