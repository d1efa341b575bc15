#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Core>

namespace leitstand {

/// A symmetric positive definite matrix of 6 x 6 blocks, most of them zero. It is factored as L L^T and
/// solved (Davis 2006, chapter 4, block by block). The constructor computes once what depends only on which
/// blocks are not zero. One thread; sums are taken in the same order each time.
class BlockCholesky {
public:
    using Block = Eigen::Matrix<double, 6, 6>;
    using Vector = Eigen::Matrix<double, 6, 1>;

    /// @p size: number of blocks on the diagonal. @p pairs: row and column of each other block that is not
    /// zero, below or above the diagonal, each once.
    BlockCholesky(std::size_t size, std::span<const std::pair<std::size_t, std::size_t>> pairs);

    /// Sets all blocks to zero.
    void clear();
    /// Adds @p block to the block @p at on the diagonal.
    void addDiagonal(std::size_t at, const Block& block);
    /// Adds @p block to the block of the constructor's pair @p index (row first, column second), and its
    /// transpose to the mirrored block.
    void addPair(std::size_t index, const Block& block);

    /// Factors the matrix with each diagonal entry times 1 + @p damping. Returns whether it is positive
    /// definite; then solve() may follow.
    [[nodiscard]] bool factor(double damping);
    /// Returns x, for which the damped matrix times x is @p right.
    [[nodiscard]] std::vector<Vector> solve(std::span<const Vector> right) const;
    /// Returns the diagonal of the diagonal block @p at, undamped.
    [[nodiscard]] Vector diagonal(std::size_t at) const;

    /// Number of blocks in the factor.
    [[nodiscard]] std::size_t blocks() const { return m_rows.size(); }

    /// A block as six columns of eight numbers, the last two always zero, so that vector registers are full.
    struct alignas(64) Padded {
        std::array<double, 48> at{};
    };
    /// Consecutive columns that have the same rows below (a supernode: Ng & Peyton 1993). Another panel is
    /// subtracted from all of them at once, and is read once for all.
    struct Panel {
        Padded* factor;
        const std::size_t* begins;  ///< where each of its columns begins in the factor
        const std::size_t* rows;    ///< rows of its first column, which begin with the panel's columns
        std::size_t size, width;    ///< rows, columns
        [[nodiscard]] Padded& block(std::size_t row, std::size_t column) const {
            return factor[begins[column] + row - column];
        }
    };

private:
    void analyse(std::span<const std::pair<std::size_t, std::size_t>> pairs);
    /// Returns whether @p column has the same rows as the column before it, except that column's diagonal.
    [[nodiscard]] bool continuesPanel(std::size_t column) const;
    [[nodiscard]] bool factorPanel(const Panel& panel, std::size_t first);
    /// Adds panel @p number to the list of the panel that has the row at @p row of @p panel among its
    /// columns.
    void wait(std::size_t number, std::size_t row, const Panel& panel);
    static void add(Padded& to, const Block& block, bool turned);

    std::size_t m_size;
    std::vector<std::size_t> m_order, m_place;  ///< node in each place of the elimination, place of each node
    std::vector<std::size_t> m_begin;           ///< of each column in m_rows, m_matrix and m_factor
    std::vector<std::size_t> m_rows;            ///< places, rising; the first of a column is the diagonal's
    std::vector<Padded> m_matrix, m_factor;
    std::vector<std::size_t> m_pairEntry;  ///< entry of each pair ...
    std::vector<bool> m_pairTurned;        ///< ... and whether its mirror is stored
    std::vector<Padded> m_inverse;         ///< of the diagonal's factors
    std::vector<std::size_t> m_panels,
        m_panelOf;  ///< panels' first columns and the end; panel of each column
    // Used during factorisation. Place of each row in the current panel; lists of panels by the panel that
    // has their next row, the cursor, as a column.
    std::vector<std::size_t> m_slot, m_next, m_cursor, m_first;
};

}  // namespace leitstand
