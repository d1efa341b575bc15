#include "core/mapping/graph/block_cholesky.h"

#include <random>

#include <gtest/gtest.h>
#include <Eigen/Cholesky>

#include "core/event/sample.h"

namespace leitstand {
namespace {

using Block = BlockCholesky::Block;
using Vector = BlockCholesky::Vector;

/// A matrix of blocks at random places, whole and in blocks.
struct Sample {
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    Eigen::MatrixXd whole;
    Eigen::VectorXd right;
    std::unique_ptr<BlockCholesky> blocks;
    std::vector<Vector> rightBlocks;
};

Sample sample(std::size_t size, double share, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    Sample sample;
    const auto side = static_cast<Eigen::Index>(6 * size);
    Eigen::MatrixXd root = Eigen::MatrixXd::Zero(side, side);
    std::vector<std::pair<std::size_t, std::size_t>> near;
    for (std::size_t row = 0; row < size; ++row) {
        for (std::size_t column = 0; column < row; ++column) {
            if (std::uniform_real_distribution<>()(random) < share) sample.pairs.emplace_back(row, column);
        }
    }
    sample.whole = Eigen::MatrixXd::Identity(side, side);
    std::vector<Block> off;
    for (const auto& [row, column] : sample.pairs) {
        const Block block = Block::NullaryExpr([&] { return normal(random); });
        off.push_back(block);
        sample.whole.block<6, 6>(Eigen::Index(6 * row), Eigen::Index(6 * column)) = block;
        sample.whole.block<6, 6>(Eigen::Index(6 * column), Eigen::Index(6 * row)) = block.transpose();
    }
    // Diagonally dominant: positive definite.
    for (Eigen::Index i = 0; i < side; ++i) sample.whole(i, i) = sample.whole.row(i).cwiseAbs().sum() + 1.0;
    sample.blocks = std::make_unique<BlockCholesky>(size, sample.pairs);
    sample.blocks->clear();
    for (std::size_t i = 0; i < size; ++i)
        sample.blocks->addDiagonal(i, sample.whole.block<6, 6>(Eigen::Index(6 * i), Eigen::Index(6 * i)));
    for (std::size_t i = 0; i < off.size(); ++i) sample.blocks->addPair(i, off[i]);
    sample.right = Eigen::VectorXd::NullaryExpr(side, [&] { return normal(random); });
    for (std::size_t i = 0; i < size; ++i)
        sample.rightBlocks.emplace_back(sample.right.segment<6>(Eigen::Index(6 * i)));
    return sample;
}

double largestDifference(const std::vector<Vector>& blocks, const Eigen::VectorXd& whole) {
    double largest = 0.0;
    for (std::size_t i = 0; i < blocks.size(); ++i)
        largest =
            std::max(largest, (blocks[i] - whole.segment<6>(Eigen::Index(6 * i))).cwiseAbs().maxCoeff());
    return largest;
}

TEST(BlockCholesky, SolvesAsADenseFactorDoes) {
    for (const auto& [size, share] :
         {std::pair(1U, 0.0), {2U, 1.0}, {12U, 0.0}, {30U, 0.1}, {40U, 0.5}, {25U, 1.0}}) {
        for (unsigned seed = 1; seed <= 5; ++seed) {
            const Sample one = sample(size, share, seed);
            ASSERT_TRUE(one.blocks->factor(0.0));
            EXPECT_LT(largestDifference(one.blocks->solve(one.rightBlocks), one.whole.llt().solve(one.right)),
                      1e-12)
                << size << " blocks, seed " << seed;
        }
    }
}

TEST(BlockCholesky, DampsTheDiagonalAndForgetsIt) {
    const Sample one = sample(20, 0.2, 3);
    Eigen::MatrixXd damped = one.whole;
    damped.diagonal() *= 1.5;
    ASSERT_TRUE(one.blocks->factor(0.5));
    EXPECT_LT(largestDifference(one.blocks->solve(one.rightBlocks), damped.llt().solve(one.right)), 1e-12);
    ASSERT_TRUE(one.blocks->factor(0.0));
    EXPECT_LT(largestDifference(one.blocks->solve(one.rightBlocks), one.whole.llt().solve(one.right)), 1e-12);
    EXPECT_DOUBLE_EQ(one.blocks->diagonal(7)[2], one.whole(44, 44));
}

TEST(BlockCholesky, FindsWhatIsNotPositiveDefinite) {
    const Sample one = sample(10, 0.3, 1);
    one.blocks->addDiagonal(4, -1e3 * Block::Identity());
    EXPECT_FALSE(one.blocks->factor(0.0));
    one.blocks->clear();
    EXPECT_FALSE(one.blocks->factor(0.0)) << "all zero";
}

TEST(BlockCholesky, FillsAChainInNowhere) {
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    for (std::size_t i = 0; i + 1 < 500; ++i) pairs.emplace_back(i + 1, i);
    EXPECT_EQ(BlockCholesky(500, pairs).blocks(), 999U);
}

}  // namespace
}  // namespace leitstand
