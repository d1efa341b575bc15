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

/// Fewest new blocks on elimination, nearly (Amestoy, Davis & Duff 1996).
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

/// The lower factor of a positive definite block, and its inverse; both have zeros above the diagonal.
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

/// to -= left * right^T, each 6 x 6 in columns of eight.
inline void subtract(double* to, const double* left, const double* right) {
    for (std::size_t c = 0; c < Side; ++c) {
        std::array<double, Stride> sum{};
        for (std::size_t m = 0; m < Side; ++m) {
            const double factor = right[m * Stride + c];
            for (std::size_t r = 0; r < Stride; ++r) sum[r] += left[m * Stride + r] * factor;
        }
        for (std::size_t r = 0; r < Stride; ++r) to[c * Stride + r] -= sum[r];
    }
}

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
    m_next.resize(size);
    m_cursor.resize(size);
    m_first.resize(size);
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
    for (const auto& [row, column] : pairs) {
        const auto [low, high] = std::minmax(m_place[row], m_place[column]);
        const auto begin = m_rows.begin() + std::ptrdiff_t(m_begin[low]),
                   end = m_rows.begin() + std::ptrdiff_t(m_begin[low + 1]);
        m_pairEntry.push_back(static_cast<std::size_t>(std::lower_bound(begin, end, high) - m_rows.begin()));
        m_pairTurned.push_back(m_place[row] < m_place[column]);
    }
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

// Sanitizers are not up yet when the loader chooses a clone.
#if defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
__attribute__((target_clones("avx2,fma", "default")))
#endif
void subtractColumns(BlockCholesky::Columns& columns, std::size_t column) {
    for (std::size_t k = columns.first[column]; k != None;) {
        const std::size_t following = columns.next[k], at = columns.cursor[k], end = columns.begin[k + 1];
        const double* const right = columns.factor[at].at.data();
        for (std::size_t i = at; i < end; ++i) {
            subtract(columns.factor[columns.slot[columns.rows[i]]].at.data(), columns.factor[i].at.data(),
                     right);
        }
        if (at + 1 < end) {
            columns.cursor[k] = at + 1;
            columns.next[k] = columns.first[columns.rows[at + 1]];
            columns.first[columns.rows[at + 1]] = k;
        }
        k = following;
    }
}

bool BlockCholesky::factor(double damping) {
    std::fill(m_first.begin(), m_first.end(), None);
    std::copy(m_matrix.begin(), m_matrix.end(), m_factor.begin());
    Columns columns{m_begin, m_rows, m_factor, m_slot, m_next, m_cursor, m_first};
    for (std::size_t column = 0; column < m_size; ++column) {
        const std::size_t begin = m_begin[column], end = m_begin[column + 1];
        for (std::size_t i = begin; i < end; ++i) m_slot[m_rows[i]] = i;
        Padded& diagonal = m_factor[begin];
        for (std::size_t i = 0; i < Side; ++i) diagonal.at[i * Stride + i] *= 1.0 + damping;
        subtractColumns(columns, column);
        if (!factorBlock(diagonal.at, m_inverse[column].at)) return false;
        for (std::size_t i = begin + 1; i < end; ++i) {
            Padded divided;
            subtract(divided.at.data(), m_factor[i].at.data(), m_inverse[column].at.data());
            for (double& value : divided.at) value = -value;
            m_factor[i] = divided;
        }
        if (begin + 1 < end) {
            m_cursor[column] = begin + 1;
            m_next[column] = m_first[m_rows[begin + 1]];
            m_first[m_rows[begin + 1]] = column;
        }
    }
    return true;
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
