#include <chrono>
#include <cmath>
#include <cstring>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/event/cloud_sample.h"
#include "core/event/stream_role.h"
#include "messages/sensor_msgs.h"
#include "tests/transport/convert/conversion.h"

namespace leitstand::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using wire::sensor_msgs::PointCloud2;
using wire::sensor_msgs::PointField;

constexpr float NaN = std::numeric_limits<float>::quiet_NaN();
constexpr std::int64_t Stamp = 1'700'000'000;  // [s]

/// A message made field by field, as drivers lay it out.
class CloudBuilder {
public:
    CloudBuilder(std::uint32_t height, std::uint32_t width, std::uint32_t pointStep,
                 std::endian order = std::endian::little)
        : m_order(order), m_data(std::size_t{height} * width * pointStep) {
        cloud.header.stamp.sec = static_cast<std::int32_t>(Stamp);
        cloud.header.frame_id = "lidar";
        cloud.height = height;
        cloud.width = width;
        cloud.point_step = pointStep;
        cloud.row_step = width * pointStep;
        cloud.is_bigendian = order == std::endian::big;
    }

    template <class T>
    CloudBuilder& field(const char* name, std::uint8_t datatype, std::uint32_t offset,
                        const std::vector<T>& values) {
        cloud.fields.push_back({name, offset, datatype, 1});
        for (std::size_t i = 0; i < values.size(); ++i) {
            std::byte* to = m_data.data() + i * cloud.point_step + offset;
            std::memcpy(to, &values[i], sizeof(T));
            if (m_order != std::endian::native) std::reverse(to, to + sizeof(T));
        }
        return *this;
    }
    template <class T = float>
    CloudBuilder& xyz(std::uint32_t offset = 0, std::uint8_t datatype = PointField::FLOAT32_) {
        const auto size = static_cast<std::uint32_t>(sizeof(T));
        return field<T>("x", datatype, offset, {1, 2, 3, 4})
            .template field<T>("y", datatype, offset + size, {10, 20, 30, 40})
            .template field<T>("z", datatype, offset + 2 * size, {-1, -2, -3, -4});
    }

    [[nodiscard]] Result<CloudSample> decoded() {
        cloud.data = m_data;
        CdrWriter out(m_order);
        encode(out, cloud);
        const SampleCase one{PointCloud2::RosName, StreamRole::Points, {}};
        auto sample = decodeCase(one, rawEvent(one, std::move(out).finish()));
        if (!sample) return sample.error();
        return sample->get<CloudSample>();
    }
    [[nodiscard]] std::string error() {
        const auto result = decoded();
        return result ? "none" : result.error().text;
    }

    PointCloud2 cloud;

private:
    std::endian m_order;
    std::vector<std::byte> m_data;
};

void expectPoints(const Result<CloudSample>& cloud) {
    ASSERT_TRUE(cloud) << cloud.error().text;
    ASSERT_EQ(cloud->points.size(), 4u);
    for (int i = 0; i < 4; ++i) {
        const auto f = static_cast<float>(i + 1);
        EXPECT_EQ(cloud->points[static_cast<std::size_t>(i)], Eigen::Vector3f(f, 10 * f, -f));
    }
}

TEST(Clouds, CoordinatesOfBothWidthsAnyOrderAndEitherByteOrder) {
    for (const std::endian order : {std::endian::little, std::endian::big}) {
        expectPoints(CloudBuilder(1, 4, 12, order).xyz().decoded());
        expectPoints(CloudBuilder(1, 4, 32, order).xyz(16).decoded());
        expectPoints(CloudBuilder(1, 4, 13, order).xyz(1).decoded());  // not aligned
        expectPoints(CloudBuilder(1, 4, 24, order).xyz<double>(0, PointField::FLOAT64_).decoded());
        expectPoints(CloudBuilder(1, 4, 12, order)
                         .field<float>("z", PointField::FLOAT32_, 0, {-1, -2, -3, -4})
                         .field<float>("x", PointField::FLOAT32_, 4, {1, 2, 3, 4})
                         .field<float>("y", PointField::FLOAT32_, 8, {10, 20, 30, 40})
                         .decoded());
    }
}

TEST(Clouds, RowsMakeAGrid) {
    const auto organised = CloudBuilder(2, 2, 12).xyz().decoded();
    ASSERT_TRUE(organised);
    EXPECT_EQ(organised->rows, 2);
    EXPECT_EQ(organised->columns, 2);
    const auto list = CloudBuilder(1, 4, 12).xyz().decoded();
    ASSERT_TRUE(list);
    EXPECT_FALSE(list->organised());
    const auto slice = CloudBuilder(1, 4, 14)
                           .xyz()
                           .field<std::uint16_t>("ring", PointField::UINT16_, 12, {7, 7, 7, 7})
                           .decoded();
    ASSERT_TRUE(slice);
    EXPECT_EQ(slice->rows, 1) << "one raw scan";
    EXPECT_THAT(slice->rings, ElementsAre(7, 7, 7, 7));
}

TEST(Clouds, NoEchoIsNaNInAllCoordinates) {
    CloudBuilder builder(1, 2, 12);
    builder.field<float>("x", PointField::FLOAT32_, 0, {NaN, 1.0F});
    builder.field<float>("y", PointField::FLOAT32_, 4, {0.0F, std::numeric_limits<float>::infinity()});
    builder.field<float>("z", PointField::FLOAT32_, 8, {0.0F, 0.0F});
    const auto cloud = builder.decoded();
    ASSERT_TRUE(cloud);
    for (const Eigen::Vector3f& point : cloud->points) EXPECT_TRUE(point.array().isNaN().all());
}

TEST(Clouds, TimesInEveryDialect) {
    const auto times = [](CloudBuilder builder) {
        const auto cloud = builder.decoded();
        EXPECT_TRUE(cloud) << cloud.error().text;
        return cloud ? cloud->times : std::vector<std::int64_t>{};
    };
    EXPECT_THAT(times(CloudBuilder(1, 4, 12).xyz()), testing::IsEmpty());
    EXPECT_THAT(times(CloudBuilder(1, 4, 16).xyz().field<std::uint32_t>("t", PointField::UINT32_, 12,
                                                                        {0, 1'000, 2'000, 4'000'000'000})),
                ElementsAre(0, 1'000, 2'000, 4'000'000'000));
    EXPECT_THAT(times(CloudBuilder(1, 4, 16).xyz().field<float>("time", PointField::FLOAT32_, 12,
                                                                {-0.5F, 0.0F, 0.25F, 0.5F})),
                ElementsAre(-500'000'000, 0, 250'000'000, 500'000'000));
    EXPECT_THAT(times(CloudBuilder(1, 4, 16).xyz().field<std::uint32_t>("time", PointField::UINT32_, 12,
                                                                        {0, 5, 6, 7})),
                ElementsAre(0, 5, 6, 7));
    const double seconds = static_cast<double>(Stamp);
    EXPECT_THAT(
        times(CloudBuilder(1, 4, 20).xyz().field<double>(
            "timestamp", PointField::FLOAT64_, 12, {seconds, seconds + 0.25, seconds + 0.5, seconds + 2})),
        ElementsAre(0, 250'000'000, 500'000'000, 2'000'000'000));
    EXPECT_THAT(times(CloudBuilder(1, 4, 20).xyz().field<double>(
                    "timestamp", PointField::FLOAT64_, 12,
                    {seconds * 1e9, seconds * 1e9 + 1024, seconds * 1e9 + 2048, seconds * 1e9 + 1e9})),
                ElementsAre(0, 1'024, 2'048, 1'000'000'000));
}

TEST(Clouds, TimesOfTheScannersOwnClockBeginAtTheStamp) {
    const double start = 2.5e8;  // seconds on a clock that never heard of 1970
    const auto cloud =
        CloudBuilder(1, 4, 20)
            .xyz()
            .field<double>("timestamp", PointField::FLOAT64_, 12, {start + 0.25, start, 0.0, start + 0.5})
            .decoded();
    ASSERT_TRUE(cloud) << cloud.error().text;
    EXPECT_THAT(cloud->times, ElementsAre(250'000'000, 0, 0, 500'000'000));
}

TEST(Clouds, TimesThatMakeNoSenseAreRefused) {
    const double seconds = static_cast<double>(Stamp);
    for (const double wrong : {seconds + 1000, 1e300, -1e300, 3e10}) {
        const std::vector<double> values = {seconds, wrong, seconds, seconds};
        CloudBuilder builder(1, 4, 20);
        builder.xyz().field<double>("timestamp", PointField::FLOAT64_, 12, values);
        EXPECT_THAT(builder.error(), HasSubstr("times")) << wrong;
    }
}

TEST(Clouds, IntensitiesAndRingsOfEveryType) {
    const auto intensities = [](CloudBuilder& builder) { return builder.decoded()->intensities; };
    CloudBuilder bytes(1, 4, 13), words(1, 4, 14), doubles(1, 4, 20);
    bytes.xyz().field<std::uint8_t>("intensity", PointField::UINT8_, 12, {0, 1, 2, 255});
    words.xyz().field<std::uint16_t>("intensity", PointField::UINT16_, 12, {0, 1, 2, 65535});
    doubles.xyz().field<double>("intensity", PointField::FLOAT64_, 12, {0, 1, 2, 0.5});
    EXPECT_THAT(intensities(bytes), ElementsAre(0, 1, 2, 255));
    EXPECT_THAT(intensities(words), ElementsAre(0, 1, 2, 65535));
    EXPECT_THAT(intensities(doubles), ElementsAre(0, 1, 2, 0.5F));
    const auto rings = [](CloudBuilder& builder) { return builder.decoded()->rings; };
    CloudBuilder small(1, 4, 13), big(1, 4, 16, std::endian::big), wrong(1, 4, 16);
    small.xyz().field<std::int8_t>("ring", PointField::INT8_, 12, {0, -1, 2, 3});
    big.xyz().field<std::int32_t>("ring", PointField::INT32_, 12, {0, 1, 2, 70000});
    wrong.xyz().field<float>("ring", PointField::FLOAT32_, 12, {0, 1, 2, 3});
    EXPECT_THAT(rings(small), ElementsAre(0, -1, 2, 3));
    EXPECT_THAT(rings(big), ElementsAre(0, 1, 2, 70000));
    EXPECT_THAT(wrong.error(), HasSubstr("ring"));
}

TEST(Clouds, RowsMayBePadded) {
    CloudBuilder builder(2, 1, 24);  // a row step of 24 and points of 12
    builder.cloud.point_step = 24;
    builder.field<float>("x", PointField::FLOAT32_, 0, {1, 2})
        .field<float>("y", PointField::FLOAT32_, 4, {10, 20})
        .field<float>("z", PointField::FLOAT32_, 8, {-1, -2});
    builder.cloud.point_step = 12;
    const auto cloud = builder.decoded();
    ASSERT_TRUE(cloud) << cloud.error().text;
    EXPECT_THAT(cloud->points, ElementsAre(Eigen::Vector3f(1, 10, -1), Eigen::Vector3f(2, 20, -2)));
}

TEST(Clouds, AnEmptyOneIsNoFault) {
    CloudBuilder none(0, 0, 12);
    none.cloud.fields = {{"x", 0, 7, 1}, {"y", 4, 7, 1}, {"z", 8, 7, 1}};
    const auto empty = none.decoded();
    ASSERT_TRUE(empty) << empty.error().text;
    EXPECT_TRUE(empty->points.empty());
}

TEST(Clouds, RowsWithoutPointsCostNothing) {
    CloudBuilder builder(2, 2, 16);
    builder.xyz().field<std::uint32_t>("t", PointField::UINT32_, 12, {0, 1, 2, 3});
    builder.cloud.height = 4'294'967'295;
    builder.cloud.width = 0;
    const auto began = std::chrono::steady_clock::now();
    const auto empty = builder.decoded();
    EXPECT_LT(std::chrono::steady_clock::now() - began, std::chrono::seconds(1));
    ASSERT_TRUE(empty) << empty.error().text;
    EXPECT_TRUE(empty->points.empty());
}

TEST(Clouds, WhatContradictsItselfIsRefused) {
    const auto errorOf = [](auto change) {
        CloudBuilder builder(2, 2, 16);
        builder.xyz().field<std::uint32_t>("t", PointField::UINT32_, 12, {0, 1, 2, 3});
        change(builder.cloud);
        return builder.error();
    };
    EXPECT_EQ(errorOf([](PointCloud2&) {}), "none");
    EXPECT_THAT(errorOf([](auto& c) { c.height = 4'000'000'000; }), HasSubstr("data"));
    EXPECT_THAT(errorOf([](auto& c) { c.width = c.height = c.row_step = 4'294'967'295; }),
                HasSubstr("row_step"));
    EXPECT_THAT(errorOf([](auto& c) { c.width = 3; }), HasSubstr("row_step"));
    EXPECT_THAT(errorOf([](auto& c) { c.row_step = 8; }), HasSubstr("row_step"));
    EXPECT_THAT(errorOf([](auto& c) { c.point_step = 0; }), HasSubstr("row_step"));
    EXPECT_THAT(errorOf([](auto& c) { c.fields.clear(); }), HasSubstr("x is missing"));
    EXPECT_THAT(errorOf([](auto& c) { c.fields[2].name = "w"; }), HasSubstr("z is missing"));
    EXPECT_THAT(errorOf([](auto& c) { c.fields[0].datatype = 9; }), HasSubstr("datatype"));
    EXPECT_THAT(errorOf([](auto& c) { c.fields[0].datatype = 5; }), HasSubstr("float32"));
    EXPECT_THAT(errorOf([](auto& c) { c.fields[1].offset = 13; }), HasSubstr("ends at byte 17"));
    EXPECT_THAT(errorOf([](auto& c) { c.fields[1].offset = 4'294'967'295; }), HasSubstr("ends at byte"));
    EXPECT_THAT(errorOf([](auto& c) { c.fields[3].datatype = 8; }), HasSubstr("t: ends at byte 20"));
    EXPECT_THAT(errorOf([](auto& c) { c.fields[0].count = 3; }), HasSubstr("one value"));
    EXPECT_THAT(errorOf([](auto& c) { c.header.stamp.nanosec = 1'000'000'000; }), HasSubstr("header.stamp"));
}

TEST(Clouds, LateTimesAndHighRingsSurviveEncoding) {
    CloudSample cloud;
    cloud.points.resize(2, Eigen::Vector3f::Ones());
    cloud.times = {-1'000, 12'000'000'001};
    cloud.rings = {-1, 70'000};
    const SampleCase one{PointCloud2::RosName, StreamRole::Points, cloud};
    const auto sample = decodeCase(one, rawEvent(one, encoded(one)));
    ASSERT_TRUE(sample) << sample.error().text;
    EXPECT_EQ(sample->get<CloudSample>().times, cloud.times);
    EXPECT_EQ(sample->get<CloudSample>().rings, cloud.rings);
}

}  // namespace
}  // namespace leitstand::test
