#pragma once

#include <QObject>

#include "app/window/panes/view_context.h"

class QWidget;

namespace leitstand {

struct LiveMoment;
class StreamList;

/// Shows what was received on every stream at the moment that a review shows.
class LoggedStreams final : public QObject {
    Q_OBJECT
public:
    explicit LoggedStreams(const ReviewContext& context);

    [[nodiscard]] QWidget& pane() const;

private:
    void show(const LiveMoment& moment);

    ViewContext m_context;
    StreamList* m_streams;
};

}  // namespace leitstand
