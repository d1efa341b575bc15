#pragma once

#include <cstdint>
#include <vector>

#include "core/event/cloud_sample.h"
#include "tests/simulation/mapping/scripted_motion.h"

namespace leitstand::simulation::test {

/// The turning scanner of Kurt3D on a scripted motion. Turns are cast by several threads at once.
class ScriptedScanner {
public:
    /// @p arena and @p motion outlive it.
    ScriptedScanner(const Arena& arena, const ScriptedMotion& motion, const Pose& mountInBase,
                    const ScriptSettings& settings);
    ~ScriptedScanner();
    ScriptedScanner(const ScriptedScanner&) = delete;
    ScriptedScanner& operator=(const ScriptedScanner&) = delete;

    [[nodiscard]] int turns() const { return static_cast<int>(m_sent.size()); }  ///< of the drive
    /// Slices of the turns from @p first to before @p last, by turns.
    [[nodiscard]] std::vector<std::vector<CloudSample>> slices(int first, int last);

private:
    struct Scenes;
    [[nodiscard]] std::vector<CloudSample> turn(std::int64_t number) const;

    const Arena& m_arena;
    const ScriptedMotion& m_motion;
    Pose m_mountInBase, m_trueMountInBase;
    ScriptSettings m_settings;
    std::vector<std::int64_t> m_sent;  ///< numbers of turns
    std::unique_ptr<Scenes> m_scenes;
};

}  // namespace leitstand::simulation::test
