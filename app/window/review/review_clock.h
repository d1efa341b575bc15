#pragma once

#include <QObject>

class QWidget;

namespace leitstand {

class ClockFace;
struct LiveMoment;
struct ViewContext;

/// Shows the mission's clock as it was at the moment that the review shows.
class ReviewClock final : public QObject {
    Q_OBJECT
public:
    explicit ReviewClock(const ViewContext& context);

    [[nodiscard]] QWidget& bar() const;  ///< widget for the top bar

private:
    void show(const LiveMoment& moment);

    ClockFace* m_face;
};

}  // namespace leitstand
