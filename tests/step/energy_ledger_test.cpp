#include <gtest/gtest.h>

#include <array>

#include <solver/step/energy_ledger.hpp>
#include <tests/support/saved_state.hpp>

/// What the ledger makes of the work of steps: each number by itself, against sums made here.
namespace pinball::energy_ledger_test {
namespace {

/// Another number for each member and each step.
ElementWork element_work(int step) {
  ElementWork work;
  double next = 1 + step;
  for (double* number :
       {&work.internal, &work.hourglass, &work.viscous, &work.hourglass_plastic, &work.folding, &work.eroded}) {
    *number = next;
    next *= 1.7;
  }
  return work;
}
ContactWork contact_work(int step) {
  ContactWork work;
  double next = 0.3 + step;
  for (double* number : {&work.stored, &work.eroded, &work.damped_power, &work.dissipated}) {
    *number = next;
    next *= 1.3;
  }
  return work;
}

TEST(EnergyLedger, BooksEveryNumberOfEveryStep) {
  EnergyLedger ledger;
  Energies sums;
  double power_before = 0;
  for (int step = 0; step < 3; ++step) {
    const ElementWork e = element_work(step);
    const ContactWork c = contact_work(step);
    const double external = -5.0 * step, dt = 0.1 + step;
    ledger.book(e, c, external, dt);
    sums.internal += e.internal - e.eroded;
    sums.hourglass += e.hourglass;
    sums.hourglass_plastic += e.hourglass_plastic;
    sums.bulk_viscosity += e.viscous;
    sums.folding = e.folding;  // of the present time
    sums.eroded += e.eroded + c.eroded;
    sums.contact_stored = c.stored;
    sums.contact_damped += (power_before + c.damped_power) / 2 * dt + c.dissipated;
    sums.external = external;
    power_before = c.damped_power;
    ledger.close(step == 0, 100);
    const Energies& booked = ledger.energies();
    EXPECT_DOUBLE_EQ(booked.internal, sums.internal);
    EXPECT_DOUBLE_EQ(booked.hourglass, sums.hourglass);
    EXPECT_DOUBLE_EQ(booked.hourglass_plastic, sums.hourglass_plastic);
    EXPECT_DOUBLE_EQ(booked.bulk_viscosity, sums.bulk_viscosity);
    EXPECT_DOUBLE_EQ(booked.folding, sums.folding);
    EXPECT_DOUBLE_EQ(booked.eroded, sums.eroded);
    EXPECT_DOUBLE_EQ(booked.contact_stored, sums.contact_stored);
    EXPECT_DOUBLE_EQ(booked.contact_damped, sums.contact_damped);
    EXPECT_DOUBLE_EQ(booked.external, sums.external);
    EXPECT_EQ(booked.kinetic, 100);
    EXPECT_DOUBLE_EQ(booked.total(), 100 + sums.internal + sums.hourglass + sums.bulk_viscosity + sums.folding +
                                         sums.eroded + sums.contact_stored + sums.contact_damped - sums.external);
  }
}

/// Adds internal energy that nothing pays for.
void err_by(EnergyLedger& ledger, double energy, double external = 0) {
  ElementWork work;
  work.internal = energy;
  ledger.book(work, {}, external, 1);
  ledger.close(false, 100 + external);
}

TEST(EnergyLedger, KeepsTheSignOfTheErrorAndTheSizeOfTheLargest) {
  EnergyLedger ledger;
  ledger.set_drift(60, 1e-9);
  ledger.close(true, 100);
  EXPECT_EQ(ledger.initial(), 100);
  EXPECT_EQ(ledger.in_motion(), 40);
  err_by(ledger, -8);
  EXPECT_DOUBLE_EQ(ledger.difference(), -8);
  EXPECT_DOUBLE_EQ(ledger.balance_error(), -0.08);
  EXPECT_DOUBLE_EQ(ledger.balance_error_in_motion(), -0.2);
  err_by(ledger, 11);
  EXPECT_DOUBLE_EQ(ledger.balance_error(), 0.03);
  EXPECT_DOUBLE_EQ(ledger.balance_error_max(), 0.08);
  EXPECT_DOUBLE_EQ(ledger.balance_error_in_motion_max(), 0.2);
  err_by(ledger, 17, -400);  // what is given to the outside counts by its size
  EXPECT_DOUBLE_EQ(ledger.balance_error(), 20.0 / 400);
  EXPECT_DOUBLE_EQ(ledger.in_motion(), 400);
  EXPECT_DOUBLE_EQ(ledger.balance_error_max(), 0.08);
}

TEST(EnergyLedger, WhereNothingMovesAnErrorIsAllThereIs) {
  EnergyLedger ledger;
  ledger.close(true, 0);
  EXPECT_EQ(ledger.balance_error(), 0);
  for (const double energy : {2.0, -3.0}) {
    ElementWork work;
    work.internal = energy;
    ledger.book(work, {}, 0, 1);
    ledger.close(false, 0);
    EXPECT_EQ(ledger.balance_error(), energy > 0 ? 1 : -1);
  }
}

TEST(EnergyLedger, GoesOnFromASavedStateAsIfItHadNotStopped) {
  EnergyLedger whole;
  whole.set_drift(60, 1e-9);
  whole.close(true, 100);
  whole.book(element_work(1), contact_work(1), -300, 0.5);
  whole.close(false, 170);
  EnergyLedger rest;
  EXPECT_EQ(test::load(rest, test::saved(whole)), 0U);
  for (EnergyLedger* ledger : {&whole, &rest}) {
    ledger->book(element_work(2), contact_work(2), -200, 0.25);
    ledger->close(false, 90);
  }
  EXPECT_EQ(rest.energies().contact_damped, whole.energies().contact_damped);
  EXPECT_EQ(rest.energies().total(), whole.energies().total());
  EXPECT_EQ(rest.initial(), whole.initial());
  EXPECT_EQ(rest.in_motion(), whole.in_motion());
  EXPECT_EQ(rest.balance_error_max(), whole.balance_error_max());
  EXPECT_EQ(rest.balance_error_in_motion_max(), whole.balance_error_in_motion_max());
}

}  // namespace
}  // namespace pinball::energy_ledger_test
