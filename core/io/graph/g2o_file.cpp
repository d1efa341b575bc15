#include "core/io/graph/g2o_file.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "core/io/detail/line_reader.h"
#include "core/io/detail/numbers.h"
#include "core/io/detail/output_file.h"

namespace leitstand {
namespace {

constexpr std::string_view Vertex = "VERTEX_SE3:QUAT", EdgeName = "EDGE_SE3:QUAT", Fix = "FIX";
constexpr std::string_view VertexExpected = "VERTEX_SE3:QUAT id x y z qx qy qz qw";
constexpr std::string_view EdgeExpected =
    "EDGE_SE3:QUAT from to x y z qx qy qz qw and 21 numbers of the information";
constexpr double MostFar = 1e7;  // [m]; public graphs are larger than scans may be

std::optional<double> takeNumber(std::string_view& line) {
    const auto number = detail::toNumber(detail::takeField(line));
    return number && std::isfinite(*number) ? number : std::nullopt;
}

bool takePose(std::string_view& line, Pose& pose) {
    Eigen::Vector3d place;
    Eigen::Vector4d turn;
    for (double& number : place) {
        const auto value = takeNumber(line);
        if (!value || std::abs(*value) > MostFar) return false;
        number = *value;
    }
    for (double& number : turn) {
        const auto value = takeNumber(line);
        if (!value) return false;
        number = *value;
    }
    constexpr double Shortest = 0.1, Longest = 10.0;
    if (!(turn.norm() >= Shortest && turn.norm() <= Longest)) return false;
    pose = Pose::Identity();
    pose.translation() = place;
    pose.linear() = Eigen::Quaterniond(turn.normalized()).toRotationMatrix();
    return true;
}

bool takeInformation(std::string_view& line, Information& information) {
    for (Eigen::Index row = 0; row < 6; ++row) {
        for (Eigen::Index column = row; column < 6; ++column) {
            const auto value = takeNumber(line);
            if (!value) return false;
            information(row, column) = information(column, row) = *value;
        }
    }
    return true;
}

bool isSemidefinite(const Information& information) {
    const double size = information.cwiseAbs().maxCoeff();
    if (size == 0.0) return true;
    const Eigen::SelfAdjointEigenSolver<Information> solver(information / size, Eigen::EigenvaluesOnly);
    return solver.info() == Eigen::Success && solver.eigenvalues().minCoeff() > -1e-9;
}

/// What has been read of a file so far.
class Reading {
public:
    explicit Reading(detail::LineReader reader) : m_reader(std::move(reader)) {}

    Result<PoseGraph> graph() {
        std::string_view line;
        while (m_reader.next(line)) {
            std::string_view rest = line;
            const std::string_view word = detail::takeField(rest);
            if (word.empty() || word.front() == '#') continue;
            std::optional<std::string_view> expected;
            if (word == Vertex) {
                expected = takeVertex(rest);
            } else if (word == EdgeName) {
                expected = takeEdge(rest);
            } else if (word == Fix) {
                expected = takeFix(rest);
            } else {
                expected = "VERTEX_SE3:QUAT, EDGE_SE3:QUAT or FIX";
            }
            if (expected) return m_reader.mismatch(*expected, line);
        }
        if (m_reader.failure()) return *m_reader.failure();
        return finished();
    }

private:
    std::optional<std::string_view> takeVertex(std::string_view rest) {
        const auto id = detail::toCount(detail::takeField(rest));
        GraphNode node;
        if (!id || !takePose(rest, node.pose) || !detail::takeField(rest).empty()) return VertexExpected;
        node.id = *id;
        if (!m_ids.insert(node.id).second) return "an id that no vertex before it has";
        m_graph.nodes.push_back(node);
        return std::nullopt;
    }
    std::optional<std::string_view> takeEdge(std::string_view rest) {
        const auto from = detail::toCount(detail::takeField(rest)),
                   to = detail::toCount(detail::takeField(rest));
        Link link;
        if (!from || !to || !takePose(rest, link.pose) || !takeInformation(rest, link.information) ||
            !detail::takeField(rest).empty())
            return EdgeExpected;
        if (!isSemidefinite(link.information)) return "an information that is positive semidefinite";
        link.id = m_graph.links.size() + 1;
        link.from = *from;
        link.to = *to;
        link.kind = link.to == link.from + 1 ? LinkKind::Odometry : LinkKind::Loop;
        m_graph.links.push_back(std::move(link));
        m_lines.push_back(m_reader.lineNumber());
        return std::nullopt;
    }
    std::optional<std::string_view> takeFix(std::string_view rest) {
        for (std::string_view field = detail::takeField(rest); !field.empty();
             field = detail::takeField(rest)) {
            const auto id = detail::toCount(field);
            if (!id) return "FIX and ids";
            m_fixed.insert(*id);
        }
        return std::nullopt;
    }
    Result<PoseGraph> finished() {
        if (m_graph.nodes.empty()) return m_reader.incomplete("vertices, found none");
        for (std::size_t i = 0; i < m_graph.links.size(); ++i) {
            const Link& link = m_graph.links[i];
            for (const std::uint64_t id : {link.from, link.to}) {
                if (!m_ids.contains(id))
                    return m_reader.incomplete(
                        fmt::format("a vertex {}, which the edge in line {} is about", id, m_lines[i]));
            }
        }
        for (const std::uint64_t id : m_fixed) {
            if (!m_ids.contains(id))
                return m_reader.incomplete(fmt::format("a vertex {}, which is to be fixed", id));
        }
        for (GraphNode& node : m_graph.nodes) node.fixed = m_fixed.contains(node.id);
        std::sort(m_graph.nodes.begin(), m_graph.nodes.end(),
                  [](const GraphNode& a, const GraphNode& b) { return a.id < b.id; });
        return std::move(m_graph);
    }

    detail::LineReader m_reader;
    PoseGraph m_graph;
    std::set<std::uint64_t> m_ids, m_fixed;
    std::vector<std::size_t> m_lines;  // line number of each link
};

void append(std::string& text, const Pose& pose) {
    const Eigen::Vector3d place = pose.translation();
    Eigen::Quaterniond turn(pose.linear());
    if (turn.w() < 0.0) turn.coeffs() = -turn.coeffs();
    for (const double number : {place.x(), place.y(), place.z(), turn.x(), turn.y(), turn.z(), turn.w()}) {
        text += ' ';
        detail::appendNumber(text, number);
    }
}

}  // namespace

Result<PoseGraph> readG2o(const std::filesystem::path& file) {
    auto opened = detail::LineReader::open(file);
    if (!opened) return opened.error();
    return Reading(std::move(opened).value()).graph();
}

Result<void> writeG2o(const std::filesystem::path& file, const PoseGraph& graph) {
    std::string text;
    for (const GraphNode& node : graph.nodes) {
        text += fmt::format("{} {}", Vertex, node.id);
        append(text, node.pose);
        text += '\n';
        if (node.fixed) text += fmt::format("{} {}\n", Fix, node.id);
    }
    for (const Link& link : graph.links) {
        if (!link.active) continue;
        text += fmt::format("{} {} {}", EdgeName, link.from, link.to);
        append(text, link.pose);
        for (Eigen::Index row = 0; row < 6; ++row) {
            for (Eigen::Index column = row; column < 6; ++column) {
                text += ' ';
                detail::appendNumber(text, link.information(row, column));
            }
        }
        text += '\n';
    }
    return detail::writeWhole(file, text);
}

}  // namespace leitstand
