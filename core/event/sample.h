#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace leitstand {

struct AlarmSample;
struct BatterySample;
struct BumpSample;
struct CameraInfoSample;
struct CandidateSample;
struct CheckpointSample;
struct ClockOffsetSample;
struct ClockSample;
struct CloudSample;
struct DetectionsSample;
struct DiagnosticsSample;
struct DriveLockSample;
struct FindSample;
struct GasSample;
struct GrantSample;
struct GridUpdateSample;
struct ImuSample;
struct JointSample;
struct JointTrajectorySample;
struct KeyScanSample;
struct MapCropSample;
struct MarkersSample;
struct MissionInfoSample;
struct ModeCommandSample;
struct ModeSample;
struct NoteSample;
struct NumbersSample;
struct OccupancyGridSample;
struct OdometrySample;
struct PathSample;
struct PictureSample;
struct PingSample;
struct PongSample;
struct PoseSample;
struct RangesSample;
struct ReadingSample;
struct RobotModelSample;
struct RobotPlaceSample;
struct ScanBodiesSample;
struct ScanLinksSample;
struct ScanPosesSample;
struct SessionSample;
struct SightingSample;
struct StopCommandSample;
struct StopStateSample;
struct StreamCommandSample;
struct TransformsSample;
struct TwistSample;
struct UndoSample;

/// A list of types; these may be undefined.
template <class... Types>
struct TypeList {
    static constexpr std::size_t Size = sizeof...(Types);
    /// Returns the index of @p Type in the list, from 0; Size if it is not in the list.
    template <class Type>
    static constexpr std::size_t indexOf() {
        std::size_t index = 0;
        static_cast<void>(((std::is_same_v<Type, Types> || (++index, false)) || ...));
        return index;
    }
};

/// All types that the content of a Sample may have. Their order affects neither log nor messages.
using SampleTypes =
    TypeList<CloudSample, RangesSample, OdometrySample, ImuSample, JointSample, TransformsSample,
             PictureSample, CameraInfoSample, GasSample, BatterySample, DiagnosticsSample, ModeSample,
             BumpSample, SightingSample, StopStateSample, PongSample, TwistSample, StopCommandSample,
             ModeCommandSample, PoseSample, StreamCommandSample, PingSample, GrantSample, FindSample,
             KeyScanSample, ScanPosesSample, RobotPlaceSample, ClockSample, ClockOffsetSample, UndoSample,
             CheckpointSample, NoteSample, SessionSample, AlarmSample, CandidateSample, MissionInfoSample,
             MapCropSample, ScanLinksSample, ScanBodiesSample, OccupancyGridSample, GridUpdateSample,
             PathSample, DriveLockSample, JointTrajectorySample, NumbersSample, ReadingSample, MarkersSample,
             RobotModelSample, DetectionsSample>;

template <class Type>
concept IsSample = (SampleTypes::indexOf<Type>() < SampleTypes::Size);

/// The content of an event, in one of core's own types (SampleTypes). Code that uses the content includes the
/// header of its type; code that only passes the sample on needs none. Copies share the content until one of
/// them is edited. A copy may be read, copied and destroyed in any thread. core/event/all_samples.h has
/// visit() and edit() for content of any type.
class Sample {
public:
    Sample() = default;  ///< has no content yet
    template <IsSample Type>
    Sample(Type content)  // NOLINT(google-explicit-constructor): a sample is one of them
        : m_content(std::make_shared<Type>(std::move(content))), m_index(SampleTypes::indexOf<Type>()) {}
    Sample(const Sample& other) : m_content(other.m_content), m_index(other.m_index), m_shared(true) {
        other.m_shared.store(true, std::memory_order_relaxed);
    }
    Sample(Sample&& other) noexcept
        : m_content(std::move(other.m_content)),
          m_index(std::exchange(other.m_index, SampleTypes::Size)),
          m_shared(other.m_shared.load(std::memory_order_relaxed)) {}
    Sample& operator=(Sample other) noexcept {
        m_content = std::move(other.m_content);
        m_index = other.m_index;
        m_shared.store(other.m_shared.load(std::memory_order_relaxed), std::memory_order_relaxed);
        return *this;
    }
    ~Sample() = default;

    /// Index of the content's type in SampleTypes; SampleTypes::Size when there is no content.
    [[nodiscard]] std::size_t index() const { return m_index; }
    template <IsSample Type>
    [[nodiscard]] bool is() const {
        return m_index == SampleTypes::indexOf<Type>();
    }
    /// Returns the content if its type is @p Type; otherwise null. Valid until this sample is edited,
    /// assigned or destroyed.
    template <IsSample Type>
    [[nodiscard]] const Type* as() const& {
        return is<Type>() ? static_cast<const Type*>(m_content.get()) : nullptr;
    }
    template <IsSample Type>
    const Type* as() const&& = delete;
    /// Returns the content, whose type must be @p Type. Valid as long as the result of as(). Throws
    /// std::logic_error if the content has another type.
    template <IsSample Type>
    [[nodiscard]] const Type& get() const& {
        if (!is<Type>()) throw std::logic_error("a sample is of another type than expected");
        return *as<Type>();
    }
    template <IsSample Type>
    [[nodiscard]] Type get() const&& {
        return get<Type>();  // of the lvalue that it is here
    }
    /// Returns the content for editing if its type is @p Type; otherwise null. If other samples may share the
    /// content, it is copied first.
    template <IsSample Type>
    [[nodiscard]] Type* edit() & {
        if (!is<Type>()) return nullptr;
        if (m_shared.load(std::memory_order_relaxed)) *this = Sample(Type(*as<Type>()));
        return static_cast<Type*>(m_content.get());
    }

private:
    std::shared_ptr<void> m_content;
    std::size_t m_index = SampleTypes::Size;
    /// Whether another sample may share the content; false again after the next edit(). use_count() cannot be
    /// used instead: it may already be 1 while another thread still finishes reading.
    mutable std::atomic<bool> m_shared = false;
};

}  // namespace leitstand
