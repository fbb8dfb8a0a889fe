#include "renderer/gl_context.h"

#include <array>
#include <cstring>
#include <stdexcept>

// glad comes first, or the others bring in the system's OpenGL header.
// clang-format off
#include <glad/gl.h>
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/osmesa.h>
// clang-format on
#include <dlfcn.h>
#include <fmt/format.h>

#include "base/error.h"

namespace lightbench {
namespace {

class OsmesaContext : public GlContext {
 public:
  OsmesaContext()
      : GlContext("osmesa", [](const char* name) -> Function { return OSMesaGetProcAddress(name); }) {
    const std::array<int, 11> attributes{OSMESA_FORMAT,
                                         OSMESA_RGBA,
                                         OSMESA_PROFILE,
                                         OSMESA_CORE_PROFILE,
                                         OSMESA_CONTEXT_MAJOR_VERSION,
                                         4,
                                         OSMESA_CONTEXT_MINOR_VERSION,
                                         5,
                                         0};
    context_.reset(OSMesaCreateContextAttribs(attributes.data(), nullptr));
    if (!context_) throw Error("OSMesa gives no OpenGL 4.5 core context");
    start();
  }

 private:
  static constexpr int kSide = 16;  // of the buffer that OSMesa insists on; nothing is drawn to it

  struct Destroy {
    void operator()(OSMesaContext context) const { OSMesaDestroyContext(context); }
  };

  void bind() override {
    if (!OSMesaMakeCurrent(context_.get(), pixels_.data(), GL_UNSIGNED_BYTE, kSide, kSide))
      throw Error("OSMesa cannot make its context current");
  }

  std::array<unsigned char, std::size_t{4} * kSide * kSide> pixels_{};
  std::unique_ptr<osmesa_context, Destroy> context_;
};

// libEGL is loaded when it is asked for, so that the program runs where there is none.
class EglLibrary {
 public:
  EglLibrary() : handle_(dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL)) {
    if (!handle_) throw Error("EGL is not there: libEGL.so.1 cannot be loaded");
  }

  // eglGetProcAddress gives every function from EGL 1.5 on, but itself only through the linker.
  template <typename Pointer>
  Pointer function(const char* name) const {
    void* symbol = dlsym(handle_.get(), name);
    if (!symbol) {
      const auto get = reinterpret_cast<PFNEGLGETPROCADDRESSPROC>(dlsym(handle_.get(), "eglGetProcAddress"));
      symbol = get ? reinterpret_cast<void*>(get(name)) : nullptr;
    }
    return reinterpret_cast<Pointer>(symbol);
  }

 private:
  // The driver's threads may outlive us: the library stays loaded.
  struct Keep {
    void operator()(void*) const {}
  };
  std::unique_ptr<void, Keep> handle_;
};

class EglContext : public GlContext {
 public:
  EglContext() : GlContext("egl", load) {
    std::string reasons;
    for (const EGLDisplay display : displays())
      if (open(display, reasons)) {
        start();
        return;
      }
    throw Error("EGL gives no OpenGL 4.5 core context" + (reasons.empty() ? "" : ": " + reasons));
  }

  ~EglContext() override {
    make_current_(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    egl_.function<PFNEGLDESTROYCONTEXTPROC>("eglDestroyContext")(display_, context_);
  }

 private:
  static Function load(const char* name) { return EglLibrary().function<Function>(name); }

  void bind() override {
    egl_.function<PFNEGLBINDAPIPROC>("eglBindAPI")(EGL_OPENGL_API);
    if (!make_current_(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_))
      throw Error("EGL cannot make its context current");
  }

  // Graphics devices in the order that EGL lists them, software rasterizers last.
  std::vector<EGLDisplay> displays() const {
    const auto get = egl_.function<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
    const auto query = egl_.function<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
    const auto describe = egl_.function<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
    if (!get) return {};
    std::array<EGLDeviceEXT, 32> devices{};
    EGLint count = 0;
    if (query) query(int(devices.size()), devices.data(), &count);
    std::vector<EGLDisplay> hardware;
    std::vector<EGLDisplay> software{get(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr)};
    for (EGLint i = 0; i < count; ++i) {
      const char* extensions = describe ? describe(devices[std::size_t(i)], EGL_EXTENSIONS) : nullptr;
      const bool is_software = extensions && std::strstr(extensions, "EGL_MESA_device_software");
      (is_software ? software : hardware)
          .push_back(get(EGL_PLATFORM_DEVICE_EXT, devices[std::size_t(i)], nullptr));
    }
    hardware.insert(hardware.end(), software.begin(), software.end());
    return hardware;
  }

  bool open(EGLDisplay display, std::string& reasons) {
    const std::array<EGLint, 7> attributes{EGL_CONTEXT_MAJOR_VERSION,
                                           4,
                                           EGL_CONTEXT_MINOR_VERSION,
                                           5,
                                           EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                           EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                           EGL_NONE};
    const auto complain = [&](const char* what) {
      reasons += fmt::format("{}{} (0x{:x})", reasons.empty() ? "" : "; ", what,
                             egl_.function<PFNEGLGETERRORPROC>("eglGetError")());
      return false;
    };
    if (display == EGL_NO_DISPLAY) return complain("no display");
    if (!egl_.function<PFNEGLINITIALIZEPROC>("eglInitialize")(display, nullptr, nullptr))
      return complain("the display cannot be initialised");
    egl_.function<PFNEGLBINDAPIPROC>("eglBindAPI")(EGL_OPENGL_API);
    context_ = egl_.function<PFNEGLCREATECONTEXTPROC>("eglCreateContext")(display, EGL_NO_CONFIG_KHR,
                                                                          EGL_NO_CONTEXT, attributes.data());
    if (context_ == EGL_NO_CONTEXT) return complain("no context");
    display_ = display;
    make_current_ = egl_.function<PFNEGLMAKECURRENTPROC>("eglMakeCurrent");
    return true;
  }

  EglLibrary egl_;
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
  PFNEGLMAKECURRENTPROC make_current_ = nullptr;
};

}  // namespace

void GlContext::make_current() {
  bind();
  // glad keeps one table of functions: fill it unless it is this library's already.
  if (reinterpret_cast<Function>(glad_glGetString) == loader_("glGetString")) return;
  if (!gladLoadGL(loader_)) throw Error(name_ + " does not give the functions of OpenGL 4.5");
}

void GlContext::start() {
  make_current();
  const auto collect = [](GLenum, GLenum type, GLuint, GLenum, GLsizei length, const GLchar* text,
                          const void* self) {
    if (type != GL_DEBUG_TYPE_ERROR) return;
    auto* context = static_cast<GlContext*>(const_cast<void*>(self));
    const std::lock_guard lock(context->mutex_);
    context->complaints_.emplace_back(text, length < 0 ? std::strlen(text) : std::size_t(length));
  };
  // Clip space z of 0..w, as reversed depth needs it (renderer/frame_camera.h).
  glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  glEnable(GL_DEBUG_OUTPUT);
  glDebugMessageCallback(collect, this);
  glDebugMessageControl(GL_DONT_CARE, GL_DONT_CARE, GL_DONT_CARE, 0, nullptr, GL_FALSE);
  glDebugMessageControl(GL_DEBUG_SOURCE_API, GL_DEBUG_TYPE_ERROR, GL_DONT_CARE, 0, nullptr, GL_TRUE);
}

void GlContext::check(const std::string& where) {
  std::string errors;
  bool out_of_memory = false;
  for (GLenum code = glGetError(); code != GL_NO_ERROR; code = glGetError()) {
    out_of_memory |= code == GL_OUT_OF_MEMORY;
    errors += fmt::format(" 0x{:04x}", code);
  }
  const std::lock_guard lock(mutex_);
  for (const std::string& complaint : complaints_) errors += " [" + complaint + "]";
  complaints_.clear();
  if (out_of_memory) throw Error("OpenGL is out of memory", where);
  if (!errors.empty()) throw std::logic_error("OpenGL error in " + where + ":" + errors);
}

void GlContext::forget_complaints() {
  while (glGetError() != GL_NO_ERROR) {
  }
  const std::lock_guard lock(mutex_);
  complaints_.clear();
}

std::string GlContext::description() {
  const auto text = [](GLenum name) { return reinterpret_cast<const char*>(glGetString(name)); };
  return fmt::format("{}, {}, {}", name_, text(GL_RENDERER), text(GL_VERSION));
}

int GlContext::max_texture_size() {
  GLint size = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &size);
  return size;
}

std::unique_ptr<GlContext> make_gl_context(GlBackend backend) {
  if (backend == GlBackend::osmesa) return std::make_unique<OsmesaContext>();
  return std::make_unique<EglContext>();
}

void throw_if_out_of_memory(const std::string& what) {
  GLenum code = glGetError();
  if (code == GL_OUT_OF_MEMORY) throw Error("OpenGL is out of memory", what);
  if (code != GL_NO_ERROR) throw std::logic_error(fmt::format("OpenGL error 0x{:04x} making {}", code, what));
}

}  // namespace lightbench
