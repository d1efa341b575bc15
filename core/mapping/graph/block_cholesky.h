#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Core>

namespace leitstand {

/// A symmetric positive definite matrix of 6 x 6 blocks of which few are not zero, factored as L L^T and
/// solved for (Davis 2006, chapter 4, block by block). What depends on where the blocks are is worked out
/// once. One thread; sums are taken in the same order each time.
class BlockCholesky {
public:
    using Block = Eigen::Matrix<double, 6, 6>;
    using Vector = Eigen::Matrix<double, 6, 1>;

    /// @p size: blocks on the diagonal; @p pairs: those below or above it that are not zero, each once.
    BlockCholesky(std::size_t size, std::span<const std::pair<std::size_t, std::size_t>> pairs);

    /// Sets all blocks to zero.
    void clear();
    /// Adds to a block on the diagonal.
    void addDiagonal(std::size_t at, const Block& block);
    /// Adds to the block in row @p pairs[index].first and column .second, and its mirror.
    void addPair(std::size_t index, const Block& block);

    /// Whether the matrix with each diagonal entry times 1 + @p damping is positive definite; then solve()
    /// may follow.
    [[nodiscard]] bool factor(double damping);
    /// The solution x of the damped matrix times x = @p right.
    [[nodiscard]] std::vector<Vector> solve(std::span<const Vector> right) const;
    /// The diagonal of a block on it, undamped.
    [[nodiscard]] Vector diagonal(std::size_t at) const;

    /// Blocks of the factor.
    [[nodiscard]] std::size_t blocks() const { return m_rows.size(); }

    /// Six columns of eight numbers, the last two of which stay zero: whole vectors of four.
    struct alignas(32) Padded {
        std::array<double, 48> at{};
    };
    /// The factor while it comes about: columns in one array, and in lists those whose next row is this one.
    struct Columns {
        const std::vector<std::size_t>&begin, &rows;
        std::vector<Padded>& factor;
        const std::vector<std::size_t>& slot;  ///< entry of each row in the column that is worked on
        std::vector<std::size_t>&next, &cursor, &first;
    };

private:
    void analyse(std::span<const std::pair<std::size_t, std::size_t>> pairs);
    static void add(Padded& to, const Block& block, bool turned);

    std::size_t m_size;
    std::vector<std::size_t> m_order, m_place;  ///< node in each place of the elimination, place of each node
    std::vector<std::size_t> m_begin;           ///< of each column in m_rows, m_matrix and m_factor
    std::vector<std::size_t> m_rows;            ///< places, rising; the first of a column is the diagonal's
    std::vector<Padded> m_matrix, m_factor;
    std::vector<std::size_t> m_pairEntry;                        ///< entry of each pair ...
    std::vector<bool> m_pairTurned;                              ///< ... and whether its mirror is stored
    std::vector<Padded> m_inverse;                               ///< of the diagonal's factors
    std::vector<std::size_t> m_slot, m_next, m_cursor, m_first;  ///< as Columns
};

}  // namespace leitstand
