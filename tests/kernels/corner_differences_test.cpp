#include <sys/mman.h>
#include <unistd.h>

#include <cstring>

#include <kernels/corner_differences.hpp>
#include <tests/support/support.hpp>

/// Corners of elements in single precision, from nodes in double.
namespace pinball::corner_differences_test {
namespace {

using namespace test;

constexpr int nodes = 200;

template <class T>
class Differences : public ::testing::Test {
 protected:
  static constexpr int W = width_of<T>;

  AlignedVector<double> records(double far) {
    AlignedVector<double> base(4 * nodes);
    for (double& x : base) x = far + uniform(random, -1, 1);
    return base;
  }
  /// Of elements that lie anywhere.
  AlignedVector<std::int32_t> anywhere() {
    AlignedVector<std::int32_t> corner(8 * W);
    for (std::int32_t& node : corner) node = static_cast<std::int32_t>(random() % nodes);
    return corner;
  }
  /// In rows of `length` elements; the last lanes begin another.
  AlignedVector<std::int32_t> rows(int length) {
    AlignedVector<std::int32_t> corner(8 * W);
    constexpr int side[8] = {0, 1, 1, 0, 0, 1, 1, 0}, line[8] = {0, 0, 1, 1, 2, 2, 3, 3};
    for (int l = 0; l < W; ++l) {
      for (int i = 0; i < 8; ++i) corner[std::size_t(i * W + l)] = 20 * line[i] + l + l / length + side[i];
    }
    return corner;
  }
  void expect_differences(const AlignedVector<double>& base, const AlignedVector<std::int32_t>& corner) {
    Vec3<T> value[8];
    gather_corners<T, W>(base.data(), corner.data(), value);
    for (int l = 0; l < W; ++l) {
      const auto at = [&](int i, int k) { return base[std::size_t(4 * corner[std::size_t(i * W + l)] + k)]; };
      for (int i = 0; i < 8; ++i) {
        const Vec3<float> found = lane_of(value[i], l);
        const float components[3] = {found.x, found.y, found.z};
        for (int k = 0; k < 3; ++k) {
          const bool by_corner_1 = i == 2 || i == 5 || i == 6;
          const float near = static_cast<float>(at(i, k) - at(by_corner_1 ? 1 : 0, k));
          const float expected = by_corner_1 ? near + static_cast<float>(at(1, k) - at(0, k)) : near;
          EXPECT_EQ(components[k], expected) << "corner " << i << " of lane " << l;
          EXPECT_NEAR(components[k], at(i, k) - at(0, k), 4 * 0x1p-24 * 2);
        }
      }
    }
  }
  Random random{7};
};
using Floats = ::testing::Types<float, Pack<float, 4>, Pack<float, 8>, Pack<float, 16>>;
TYPED_TEST_SUITE(Differences, Floats);

TYPED_TEST(Differences, OfElementsThatLieAnywhere) {
  for (int trial = 0; trial < 20; ++trial) this->expect_differences(this->records(0), this->anywhere());
}

TYPED_TEST(Differences, OfRowsOfAnyLengthHaveTheSameBits) {
  for (int length = 1; length <= 17; ++length) this->expect_differences(this->records(3), this->rows(length));
}

/// A row but for one corner, of each lane once.
TYPED_TEST(Differences, OfRowsThatBreakAnywhere) {
  for (int l = 0; l < this->W; ++l) {
    for (int i = 0; i < 8; ++i) {
      AlignedVector<std::int32_t> corner = this->rows(100);
      corner[std::size_t(i * this->W + l)] = nodes - 1;
      this->expect_differences(this->records(0), corner);
    }
  }
}

/// The last pack of all ends where its numbers do: what lies behind may be nobody's.
TYPED_TEST(Differences, AskForNoNumberBehindThePack) {
  const AlignedVector<std::int32_t> corner = this->rows(5);
  const AlignedVector<double> base = this->records(0);
  const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE)), bytes = corner.size() * sizeof(std::int32_t);
  void* const pages = mmap(nullptr, 2 * page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  ASSERT_NE(pages, MAP_FAILED);
  char* const end = static_cast<char*>(pages) + page;
  ASSERT_EQ(mprotect(end, page, PROT_NONE), 0);
  std::memcpy(end - bytes, corner.data(), bytes);
  Vec3<TypeParam> value[8];
  gather_corners<TypeParam, width_of<TypeParam>>(base.data(), reinterpret_cast<const std::int32_t*>(end - bytes),
                                                 value);
  munmap(pages, 2 * page);
  this->expect_differences(base, corner);
}

TYPED_TEST(Differences, LoseNothingFarFromTheOrigin) {
  using T = TypeParam;
  const AlignedVector<std::int32_t> corner = this->rows(5);
  AlignedVector<double> near = this->records(0), far = near;
  for (double& x : near) x = std::round(0x1p20 * x) * 0x1p-20;  // sums are exact
  for (std::size_t i = 0; i < far.size(); ++i) far[i] = near[i] + 0x1p20;
  Vec3<T> a[8], b[8];
  gather_corners<T, width_of<T>>(near.data(), corner.data(), a);
  gather_corners<T, width_of<T>>(far.data(), corner.data(), b);
  for (int i = 0; i < 8; ++i) {
    for (int l = 0; l < width_of<T>; ++l) EXPECT_VECTOR_NEAR(lane_of(a[i], l), lane_of(b[i], l), 0);
  }
}

TYPED_TEST(Differences, ForcesAreAddedInDoubleLaneAfterLane) {
  using T = TypeParam;
  constexpr int lanes = width_of<T>;
  for (const int different : {1, 2, 3, nodes}) {
    AlignedVector<double> found = this->records(0), expected = found;
    AlignedVector<std::int32_t> index(lanes);
    for (std::int32_t& node : index) node = static_cast<std::int32_t>(this->random() % std::uint64_t(different));
    AlignedVector<float> values[4];
    for (AlignedVector<float>& component : values) {
      for (int l = 0; l < lanes; ++l) {
        const double size = std::pow(10.0, uniform(this->random, -6, 6));
        component.push_back(static_cast<float>(uniform(this->random, -size, size)));
      }
    }
    add_to_records(found.data(), index.data(), load<T>(values[0].data()), load<T>(values[1].data()),
                   load<T>(values[2].data()), load<T>(values[3].data()));
    for (int l = 0; l < lanes; ++l) {
      for (int k = 0; k < 4; ++k) {
        expected[std::size_t(4 * index[std::size_t(l)] + k)] += double(values[k][std::size_t(l)]);
      }
    }
    EXPECT_EQ(found, expected) << different;
  }
}

TYPED_TEST(Differences, ForcesOfAnElementAreInBalanceInDouble) {
  using T = TypeParam;
  constexpr int lanes = width_of<T>;
  for (int trial = 0; trial < 20; ++trial) {
    AlignedVector<double> found = this->records(0), expected = found;
    const AlignedVector<std::int32_t> corner = this->rows(trial + 1);
    AlignedVector<float> values(24 * lanes);
    for (float& v : values) v = static_cast<float>(uniform(this->random, -1, 1));
    Vec3<T> value[8];
    for (int i = 0; i < 8; ++i) {
      const float* const of = values.data() + 3 * i * lanes;
      value[i] = {load<T>(of), load<T>(of + lanes), load<T>(of + 2 * lanes)};
    }
    add_balance_to_records(found.data(), corner.data(), value);
    for (int l = 0; l < lanes; ++l) {
      for (int k = 0; k < 3; ++k) {
        double sum = 0;
        for (int i = 1; i < 8; ++i) sum += double(values[std::size_t((3 * i + k) * lanes + l)]);
        expected[std::size_t(4 * corner[std::size_t(l)] + k)] -= sum;
      }
    }
    EXPECT_EQ(found, expected);
  }
}

}  // namespace
}  // namespace pinball::corner_differences_test
