#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include <kernels/material/power.hpp>

/// Against the library's functions in long double.
namespace pinball::power_test {
namespace {

template <class S>
constexpr double digit = std::numeric_limits<S>::epsilon();

/// Numbers over the whole range, and near 1.
template <class S, class Check>
void for_each_number(const Check& check) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> exponent(std::log(1.01 * std::numeric_limits<S>::min()),
                                                  std::log(0.99 * std::numeric_limits<S>::max())),
      near(-0.5, 0.5);
  for (int i = 0; i < 20000; ++i) check(static_cast<S>(std::exp(exponent(random))));
  for (int i = 0; i < 20000; ++i) check(static_cast<S>(1 + near(random)));
  for (const double one : {1.0, 2.0, 0.5, std::sqrt(0.5), std::sqrt(2.0), 1 + 1e-7, 1 - 1e-7}) {
    const S x = static_cast<S>(one);
    check(x);
    check(std::nextafter(x, S(0)));
    check(std::nextafter(x, S(4)));
  }
}

template <class S>
void expect_logarithms() {
  for_each_number<S>([](S x) {
    const long double exact = std::log(static_cast<long double>(x));
    EXPECT_LE(std::abs(static_cast<double>(logarithm(x) - exact)), 2 * digit<S> * std::abs(exact)) << x;
  });
  EXPECT_EQ(logarithm(S(1)), S(0));
}

TEST(Power, HasLogarithmsToTheLastDigits) {
  expect_logarithms<double>();
  expect_logarithms<float>();
}

/// ln(1 + x) and e^x - 1 of numbers of any size.
template <class S>
void expect_digits_near_one() {
  std::mt19937_64 random(9);
  std::uniform_real_distribution<double> exponent(-30, 2), below(-0.9999, 0);
  const auto expect_digits = [](double found, long double exact, S x) {
    EXPECT_LE(std::abs(static_cast<double>(found - exact)), 4 * digit<S> * std::abs(static_cast<double>(exact))) << x;
  };
  for (int i = 0; i < 20000; ++i) {
    const S size = static_cast<S>(std::exp(exponent(random)));
    for (const S x : {size, static_cast<S>(-size)}) {
      expect_digits(exponential_less_one(x), std::expm1(static_cast<long double>(x)), x);
      if (x > S(-0.9)) expect_digits(logarithm_of_one_and(x), std::log1p(static_cast<long double>(x)), x);
    }
    const S less = static_cast<S>(below(random));
    expect_digits(logarithm_of_one_and(less), std::log1p(static_cast<long double>(less)), less);
  }
  EXPECT_EQ(exponential_less_one(S(0)), S(0));
  EXPECT_EQ(logarithm_of_one_and(S(0)), S(0));
  EXPECT_TRUE(std::isnan(exponential_less_one(std::numeric_limits<S>::quiet_NaN())));
}

TEST(Power, HasAllDigitsNearOne) {
  expect_digits_near_one<double>();
  expect_digits_near_one<float>();
}

template <class S>
void expect_exponentials() {
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> wide(sizeof(S) == 8 ? -708 : -87, sizeof(S) == 8 ? 709 : 88), near(-1, 1);
  const auto check = [](S x) {
    const long double exact = std::exp(static_cast<long double>(x));
    EXPECT_LE(std::abs(static_cast<double>((exponential(x) - exact) / exact)), 2 * digit<S>) << x;
  };
  for (int i = 0; i < 20000; ++i) {
    check(static_cast<S>(wide(random)));
    check(static_cast<S>(near(random)));
  }
  EXPECT_EQ(exponential(S(0)), S(1));
  EXPECT_EQ(exponential(S(-1000)), S(0));
}

TEST(Power, HasExponentialsToTheLastDigits) {
  expect_exponentials<double>();
  expect_exponentials<float>();
}

template <class S>
void expect_powers() {
  std::mt19937_64 random(9);
  std::uniform_real_distribution<double> base(-12, 12), exponent(-3, 3);
  for (int i = 0; i < 20000; ++i) {
    const S a = static_cast<S>(std::exp(base(random))), b = static_cast<S>(exponent(random));
    const long double exact = std::pow(static_cast<long double>(a), static_cast<long double>(b));
    const double of_exponent = std::abs(static_cast<double>(b * std::log(static_cast<long double>(a))));
    EXPECT_LE(std::abs(static_cast<double>((power(a, b) - exact) / exact)), (2 + 2 * of_exponent) * digit<S>) << a;
  }
}

TEST(Power, HasPowersToTheDigitsOfTheirLogarithm) {
  expect_powers<double>();
  expect_powers<float>();
}

TEST(Power, OfZeroIsZeroAndOfNoNumberNone) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(power(0.0, 0.3), 0.0);
  EXPECT_EQ(power(1.0, 0.3), 1.0);
  EXPECT_TRUE(std::isnan(power(none, 0.3)));
  EXPECT_TRUE(std::isnan(logarithm(none)));
  EXPECT_TRUE(std::isnan(exponential(none)));
}

TEST(Power, OfPacksIsThatOfTheirLanes) {
  using T = Pack<double, 8>;
  std::mt19937_64 random(10);
  std::uniform_real_distribution<double> uniform(-5, 5);
  for (int i = 0; i < 1000; ++i) {
    alignas(64) double x[8], found[8];
    for (double& one : x) one = std::exp(uniform(random));
    store(power(load<T>(x), 0.37), found);
    for (int lane = 0; lane < 8; ++lane) EXPECT_NEAR(found[lane], power(x[lane], 0.37), 1e-15 * found[lane]);
    store(logarithm(load<T>(x)), found);
    for (int lane = 0; lane < 8; ++lane) EXPECT_NEAR(found[lane], logarithm(x[lane]), 1e-15);
  }
}

}  // namespace
}  // namespace pinball::power_test
