#include "app/window/shell/picture_size.h"

#include <gtest/gtest.h>
#include <QColor>

namespace leitstand::test {
namespace {

TEST(PictureSize, TheWindowIsAsMuchSmallerAsTheScreenIsFiner) {
    EXPECT_EQ(windowSizeFor(QSize(3840, 2160), 1.0), QSize(3840, 2160));
    EXPECT_EQ(windowSizeFor(QSize(3840, 2160), 2.0), QSize(1920, 1080));
    EXPECT_EQ(windowSizeFor(QSize(3840, 2160), 1.2), QSize(3200, 1800)) << "no unit more by rounding";
    EXPECT_EQ(windowSizeFor(QSize(1281, 801), 2.0), QSize(641, 401)) << "not a pixel is missing";
    EXPECT_EQ(windowSizeFor(std::nullopt, 2.0), QSize(1280, 800)) << "the usual window";
}

TEST(PictureSize, WhatIsThereByRoundingIsCut) {
    QImage picture(1282, 802, QImage::Format_RGB32);
    picture.fill(Qt::white);
    picture.setPixelColor(1280, 800, Qt::red);
    picture.setDevicePixelRatio(2.0);  // as the pictures of windows
    const QImage cut = cutToSize(picture, QSize(1281, 801), 2.0);
    EXPECT_EQ(cut.size(), QSize(1281, 801));
    EXPECT_EQ(cut.pixel(1280, 800), QColor(Qt::red).rgb());
    EXPECT_EQ(cutToSize(picture, QSize(1282, 802), 2.0).size(), picture.size());
    EXPECT_EQ(cutToSize(picture, std::nullopt, 2.0).size(), picture.size());
}

TEST(PictureSize, AWindowThatCannotBeSoSmallIsShownWhole) {
    const QImage picture(1000, 640, QImage::Format_RGB32);
    EXPECT_EQ(cutToSize(picture, QSize(640, 640), 2.0).size(), QSize(1000, 640));
}

TEST(PictureSize, EveryPixelThatIsAskedForIsThereAtEveryScale) {
    for (const double scale : {1.0, 1.25, 1.333, 1.5, 1.75, 2.0, 3.0}) {
        for (int side = 320; side < 8192; side += 37) {
            const QSize window = windowSizeFor(QSize(side, side), scale);
            const int pixels = qRound(window.width() * scale);
            EXPECT_GE(pixels, side) << scale;
            EXPECT_LT(pixels, side + scale + 1) << scale;
        }
    }
}

}  // namespace
}  // namespace leitstand::test
