#include "widgets/dialogs/about_dialog.h"

#include "core/base/version.h"
#include "widgets/base/named.h"
#include "widgets/view/render/passes/gl_setup.h"
#include <QClipboard>
#include <QDialogButtonBox>
#include <QGuiApplication>
#include <QIcon>
#include <QLabel>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QPushButton>
#include <QVBoxLayout>

namespace ramure {
namespace {

QString openGlText()
{
    QString reason;
    if (!openGlAvailable(&reason))
        return reason;
    QOpenGLContext context;
    QOffscreenSurface surface;
    surface.create();
    if (!context.create() || !context.makeCurrent(&surface))
        return AboutDialog::tr("not available");
    const auto text = [&](GLenum name) {
        return QString::fromUtf8(reinterpret_cast<const char*>(context.functions()->glGetString(name)));
    };
    const QString result = QStringLiteral("%1 (%2)").arg(text(GL_RENDERER), text(GL_VERSION));
    context.doneCurrent();
    return result;
}

} // namespace

QString AboutDialog::versions()
{
    return tr("Ramure %1\nQt %2 (compiled with %3)\nOpenGL: %4\n%5")
        .arg(QStringLiteral(RAMURE_VERSION), QString::fromLatin1(qVersion()), QStringLiteral(QT_VERSION_STR),
             openGlText(), QSysInfo::prettyProductName());
}

AboutDialog::AboutDialog(QWidget* parent)
    : QDialog(parent)
{
    setWindowTitle(tr("About Ramure"));
    auto* layout = layoutOf<QVBoxLayout>(this, 10, {28, 24, 28, 18});
    layout->setSizeConstraint(QLayout::SetFixedSize);
    auto* title = new QLabel(QStringLiteral("<span style='font-size:18pt'>Ramure</span>"), this);
    auto* line = new QLabel(tr("An editor for trees: from a grammar to one clean mesh."), this);
    auto* facts = new QLabel(versions(), this);
    facts->setObjectName(QStringLiteral("dim"));
    facts->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    auto* licence = new QLabel(tr("Free software under the MIT licence."), this);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    QPushButton* copy = buttons->addButton(tr("Copy versions"), QDialogButtonBox::ActionRole);
    copy->setAutoDefault(false);
    layout->addWidget(title);
    layout->addWidget(line);
    layout->addSpacing(6);
    layout->addWidget(facts);
    layout->addSpacing(6);
    layout->addWidget(licence);
    layout->addSpacing(8);
    layout->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(copy, &QPushButton::clicked, this, [] { QGuiApplication::clipboard()->setText(versions()); });
}

} // namespace ramure
