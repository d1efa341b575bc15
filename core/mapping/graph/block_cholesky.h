#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Core>

namespace leitstand {

/// A symmetric positive definite matrix of 6 x 6 blocks, most of which are zero. It is factored as L L^T and
/// solved (Davis 2006, chapter 4, block by block). The constructor computes all that depends only on which
/// blocks are not zero. For one thread; sums are taken in the same order each time.
class BlockCholesky {
public:
    using Block = Eigen::Matrix<double, 6, 6>;
    using Vector = Eigen::Matrix<double, 6, 1>;

    /// @p size: number of blocks on the diagonal. @p pairs: row and column of each other block that is not
    /// zero, above or below the diagonal. Each pair is listed once.
    BlockCholesky(std::size_t size, std::span<const std::pair<std::size_t, std::size_t>> pairs);

    /// Sets all blocks to zero.
    void clear();
    /// Adds @p block to the diagonal block with index @p at.
    void addDiagonal(std::size_t at, const Block& block);
    /// Adds @p block to the block at the constructor's pair number @p index (row, column), and its transpose
    /// to the mirrored block.
    void addPair(std::size_t index, const Block& block);

    /// Factors the matrix after multiplying each diagonal entry by 1 + @p damping. Returns whether it is
    /// positive definite; then solve() may be called.
    [[nodiscard]] bool factor(double damping);
    /// Returns x, where the damped matrix times x is @p right.
    [[nodiscard]] std::vector<Vector> solve(std::span<const Vector> right) const;
    /// Returns the diagonal of the diagonal block @p at, without damping.
    [[nodiscard]] Vector diagonal(std::size_t at) const;

    /// Number of blocks in the factor.
    [[nodiscard]] std::size_t blocks() const { return m_rows.size(); }

    /// A block as six columns of eight numbers. The last two of each are always zero, so that they fill
    /// vector registers.
    struct alignas(64) Padded {
        std::array<double, 48> at{};
    };
    /// Consecutive columns that have the same rows below the diagonal (a supernode: Ng & Peyton 1993).
    /// Another panel is read once and subtracted from all of these columns together.
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
    /// Puts panel @p number into the waiting list of another panel: the one that has the row at @p row of
    /// @p panel among its columns.
    void wait(std::size_t number, std::size_t row, const Panel& panel);
    static void add(Padded& to, const Block& block, bool turned);

    std::size_t m_size;
    /// Node at each place of the elimination, and place of each node.
    std::vector<std::size_t> m_order, m_place;
    std::vector<std::size_t> m_begin;  ///< where each column begins in m_rows, m_matrix and m_factor
    std::vector<std::size_t> m_rows;   ///< places in rising order; the first of a column is its diagonal
    std::vector<Padded> m_matrix, m_factor;
    std::vector<std::size_t> m_pairEntry;  ///< matrix entry of each pair ...
    std::vector<bool> m_pairTurned;        ///< ... and whether the mirrored block is stored instead
    std::vector<Padded> m_inverse;         ///< inverses of the factor's diagonal blocks
    std::vector<std::size_t> m_panels,
        m_panelOf;  ///< first column of each panel and the end; panel of each column
    // Used during factorisation. Place of each row in the current panel; lists of panels by the panel that
    // has their next row, the cursor, as a column.
    std::vector<std::size_t> m_slot, m_next, m_cursor, m_first;
};

}  // namespace leitstand
