#include "core/mapping/graph/block_cholesky.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>

namespace leitstand {
namespace {

constexpr std::size_t Stride = 8, Side = 6;
constexpr std::size_t None = static_cast<std::size_t>(-1);

/// Returns an elimination order with nearly the fewest new blocks (Amestoy, Davis & Duff 1996).
std::vector<std::size_t> eliminationOrder(std::size_t size,
                                          std::span<const std::pair<std::size_t, std::size_t>> pairs) {
    using Pattern = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;
    std::vector<Eigen::Triplet<double, int>> entries;
    entries.reserve(size + 2 * pairs.size());
    for (std::size_t i = 0; i < size; ++i) entries.emplace_back(int(i), int(i), 1.0);
    for (const auto& [row, column] : pairs) {
        entries.emplace_back(int(row), int(column), 1.0);
        entries.emplace_back(int(column), int(row), 1.0);
    }
    Pattern pattern(static_cast<int>(size), static_cast<int>(size));
    pattern.setFromTriplets(entries.begin(), entries.end());
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
    Eigen::AMDOrdering<int>()(pattern, order);
    std::vector<std::size_t> nodes(size);
    for (std::size_t i = 0; i < size; ++i) nodes[i] = static_cast<std::size_t>(order.indices()[int(i)]);
    return nodes;
}

/// Replaces a positive definite @p block by its lower factor and computes that one's inverse; both have zeros
/// above the diagonal. Returns false when it is not positive definite.
bool factorBlock(std::array<double, 48>& block, std::array<double, 48>& inverse) {
    using Matrix = Eigen::Matrix<double, 6, 6>;
    Matrix whole;
    for (std::size_t c = 0; c < Side; ++c) {
        for (std::size_t r = 0; r < Side; ++r)
            whole(Eigen::Index(r), Eigen::Index(c)) = block[c * Stride + r];
    }
    const Eigen::LLT<Matrix> factor(whole);
    if (factor.info() != Eigen::Success) return false;
    const Matrix lower = factor.matrixL();
    if (!lower.allFinite()) return false;
    const Matrix back = lower.triangularView<Eigen::Lower>().solve(Matrix::Identity());
    for (std::size_t c = 0; c < Side; ++c) {
        for (std::size_t r = 0; r < Side; ++r) {
            block[c * Stride + r] = lower(Eigen::Index(r), Eigen::Index(c));
            inverse[c * Stride + r] = back(Eigen::Index(r), Eigen::Index(c));
        }
    }
    return true;
}

/// Eight numbers in as many registers as they need.
using Column = double __attribute__((vector_size(Stride * sizeof(double))));

}  // namespace

BlockCholesky::BlockCholesky(std::size_t size, std::span<const std::pair<std::size_t, std::size_t>> pairs)
    : m_size(size) {
    m_order = eliminationOrder(size, pairs);
    m_place.resize(size);
    for (std::size_t place = 0; place < size; ++place) m_place[m_order[place]] = place;
    analyse(pairs);
    m_matrix.resize(m_rows.size());
    m_factor.resize(m_rows.size());
    m_inverse.resize(size);
    m_slot.resize(size);
    const std::size_t panels = m_panels.size() - 1;
    m_next.resize(panels);
    m_cursor.resize(panels);
    m_first.resize(panels);
}

void BlockCholesky::analyse(std::span<const std::pair<std::size_t, std::size_t>> pairs) {
    std::vector<std::vector<std::size_t>> below(m_size), children(m_size);
    for (const auto& [row, column] : pairs) {
        const auto [low, high] = std::minmax(m_place[row], m_place[column]);
        below[low].push_back(high);
    }
    m_begin.assign(1, 0);
    std::vector<std::size_t> seen(m_size, None);
    for (std::size_t column = 0; column < m_size; ++column) {
        std::vector<std::size_t>& rows = below[column];
        for (const std::size_t row : rows) seen[row] = column;
        for (const std::size_t child : children[column]) {
            for (std::size_t i = m_begin[child] + 1; i < m_begin[child + 1]; ++i) {
                const std::size_t row = m_rows[i];
                if (row == column || seen[row] == column) continue;
                seen[row] = column;
                rows.push_back(row);
            }
        }
        std::sort(rows.begin(), rows.end());
        if (!rows.empty()) children[rows.front()].push_back(column);
        m_rows.push_back(column);
        m_rows.insert(m_rows.end(), rows.begin(), rows.end());
        m_begin.push_back(m_rows.size());
        rows = {};
    }
    m_panelOf.resize(m_size);
    for (std::size_t column = 0; column < m_size; ++column) {
        if (column == 0 || !continuesPanel(column)) m_panels.push_back(column);
        m_panelOf[column] = m_panels.size() - 1;
    }
    m_panels.push_back(m_size);
    for (const auto& [row, column] : pairs) {
        const auto [low, high] = std::minmax(m_place[row], m_place[column]);
        const auto begin = m_rows.begin() + std::ptrdiff_t(m_begin[low]),
                   end = m_rows.begin() + std::ptrdiff_t(m_begin[low + 1]);
        m_pairEntry.push_back(static_cast<std::size_t>(std::lower_bound(begin, end, high) - m_rows.begin()));
        m_pairTurned.push_back(m_place[row] < m_place[column]);
    }
}

bool BlockCholesky::continuesPanel(std::size_t column) const {
    constexpr std::size_t Widest = 16;  // of wider ones the rows leave the cache
    const std::size_t before = column - 1, rows = m_begin[column] - m_begin[before];
    return rows == m_begin[column + 1] - m_begin[column] + 1 && m_rows[m_begin[before] + 1] == column &&
           column - m_panels.back() < Widest;
}

void BlockCholesky::clear() {
    for (Padded& block : m_matrix) block.at.fill(0.0);
}

void BlockCholesky::add(Padded& to, const Block& block, bool turned) {
    for (std::size_t c = 0; c < Side; ++c) {
        for (std::size_t r = 0; r < Side; ++r) {
            const auto row = static_cast<Eigen::Index>(turned ? c : r),
                       column = static_cast<Eigen::Index>(turned ? r : c);
            to.at[c * Stride + r] += block(row, column);
        }
    }
}

void BlockCholesky::addDiagonal(std::size_t at, const Block& block) {
    add(m_matrix[m_begin[m_place[at]]], block, false);
}

void BlockCholesky::addPair(std::size_t index, const Block& block) {
    add(m_matrix[m_pairEntry[index]], block, m_pairTurned[index]);
}

BlockCholesky::Vector BlockCholesky::diagonal(std::size_t at) const {
    const Padded& block = m_matrix[m_begin[m_place[at]]];
    Vector result;
    for (std::size_t i = 0; i < Side; ++i) result[Eigen::Index(i)] = block.at[i * Stride + i];
    return result;
}

// Sanitizers are not initialised yet when the loader chooses a clone.
#if defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define LEITSTAND_CLONES __attribute__((target_clones("avx512f", "avx2,fma", "default")))
#else
#define LEITSTAND_CLONES
#endif

/// Subtracts L_i L_j^T from the block of row i and column j of the panel @p to. Row j is any row of the panel
/// @p from between @p first and @p last, which are columns of the panel @p to. Row i is any row from j on. @p
/// slot: the place in the panel @p to of each row of the matrix.
LEITSTAND_CLONES
void subtractPanel(const BlockCholesky::Panel& from, std::size_t first, std::size_t last,
                   const BlockCholesky::Panel& to, const std::size_t* slot) {
    for (std::size_t j = first; j < last; ++j) {
        const std::size_t column = slot[from.rows[j]];
        for (std::size_t i = j; i < from.size; ++i) {
            Column sums[Side] = {};
            for (std::size_t k = 0; k < from.width; ++k) {
                const double* const left = from.block(i, k).at.data();
                const double* const right = from.block(j, k).at.data();
                for (std::size_t m = 0; m < Side; ++m) {
                    const Column values = *reinterpret_cast<const Column*>(left + m * Stride);
                    for (std::size_t c = 0; c < Side; ++c) sums[c] += values * right[m * Stride + c];
                }
            }
            double* const block = to.block(slot[from.rows[i]], column).at.data();
            for (std::size_t c = 0; c < Side; ++c) {
                for (std::size_t r = 0; r < Stride; ++r) block[c * Stride + r] -= sums[c][r];
            }
        }
    }
}

/// Divides the blocks of @p panel below the diagonal of @p column by the diagonal's lower factor. @p inverse:
/// that factor's inverse.
LEITSTAND_CLONES
void divideColumn(const BlockCholesky::Panel& panel, std::size_t column, const double* inverse) {
    for (std::size_t i = column + 1; i < panel.size; ++i) {
        double* const block = panel.block(i, column).at.data();
        Column divided[Side] = {};
        for (std::size_t c = 0; c < Side; ++c) {
            // The inverse has zeros above its diagonal.
            for (std::size_t m = 0; m <= c; ++m)
                divided[c] += *reinterpret_cast<const Column*>(block + m * Stride) * inverse[m * Stride + c];
        }
        for (std::size_t c = 0; c < Side; ++c) {
            for (std::size_t r = 0; r < Stride; ++r) block[c * Stride + r] = divided[c][r];
        }
    }
}

/// Factors @p panel, from which all panels before it are subtracted.
bool BlockCholesky::factorPanel(const Panel& panel, std::size_t first) {
    for (std::size_t column = 0; column < panel.width; ++column) {
        Padded& inverse = m_inverse[first + column];
        if (!factorBlock(panel.block(column, column).at, inverse.at)) return false;
        divideColumn(panel, column, inverse.at.data());
        // For the panel's later columns, this one is a panel of one column.
        Panel done = panel;
        done.begins += column;
        done.rows += column;
        done.size -= column;
        done.width = 1;
        subtractPanel(done, 1, panel.width - column, panel, m_slot.data());
    }
    return true;
}

bool BlockCholesky::factor(double damping) {
    std::fill(m_first.begin(), m_first.end(), None);
    std::copy(m_matrix.begin(), m_matrix.end(), m_factor.begin());
    for (std::size_t column = 0; column < m_size; ++column) {
        Padded& diagonal = m_factor[m_begin[column]];
        for (std::size_t i = 0; i < Side; ++i) diagonal.at[i * Stride + i] *= 1.0 + damping;
    }
    const auto panelOf = [this](std::size_t number) {
        const std::size_t first = m_panels[number];
        return Panel{m_factor.data(), m_begin.data() + first, m_rows.data() + m_begin[first],
                     m_begin[first + 1] - m_begin[first], m_panels[number + 1] - first};
    };
    for (std::size_t number = 0; number + 1 < m_panels.size(); ++number) {
        const Panel panel = panelOf(number);
        for (std::size_t i = 0; i < panel.size; ++i) m_slot[panel.rows[i]] = i;
        for (std::size_t other = m_first[number]; other != None;) {
            const std::size_t following = m_next[other];
            const Panel before = panelOf(other);
            std::size_t last = m_cursor[other];
            while (last < before.size && m_panelOf[before.rows[last]] == number) ++last;
            subtractPanel(before, m_cursor[other], last, panel, m_slot.data());
            wait(other, last, before);
            other = following;
        }
        if (!factorPanel(panel, m_panels[number])) return false;
        wait(number, panel.width, panel);
    }
    return true;
}

void BlockCholesky::wait(std::size_t number, std::size_t row, const Panel& panel) {
    if (row == panel.size) return;
    std::size_t& first = m_first[m_panelOf[panel.rows[row]]];
    m_cursor[number] = row;
    m_next[number] = first;
    first = number;
}

std::vector<BlockCholesky::Vector> BlockCholesky::solve(std::span<const Vector> right) const {
    const auto matrix = [](const Padded& block) {
        return Eigen::Map<const Block, 0, Eigen::OuterStride<Stride>>(block.at.data());
    };
    std::vector<Vector> x(m_size);
    for (std::size_t place = 0; place < m_size; ++place) x[place] = right[m_order[place]];
    for (std::size_t column = 0; column < m_size; ++column) {
        x[column] = (matrix(m_inverse[column]) * x[column]).eval();
        for (std::size_t i = m_begin[column] + 1; i < m_begin[column + 1]; ++i)
            x[m_rows[i]].noalias() -= matrix(m_factor[i]) * x[column];
    }
    for (std::size_t column = m_size; column-- > 0;) {
        for (std::size_t i = m_begin[column] + 1; i < m_begin[column + 1]; ++i)
            x[column].noalias() -= matrix(m_factor[i]).transpose() * x[m_rows[i]];
        x[column] = (matrix(m_inverse[column]).transpose() * x[column]).eval();
    }
    std::vector<Vector> result(m_size);
    for (std::size_t place = 0; place < m_size; ++place) result[m_order[place]] = x[place];
    return result;
}

}  // namespace leitstand
