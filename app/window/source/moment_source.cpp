#include "app/window/source/moment_source.h"

namespace leitstand {

void MomentSource::notify(const QString& text) {
    m_messages.addReported(text);
    emit notified(text);
}

}  // namespace leitstand
