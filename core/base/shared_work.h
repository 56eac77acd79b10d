#pragma once
/// Work that several threads share. Threads that help sleep in between, so they cost other programs nothing.

namespace nilas {

/// Calls call(body) on this thread and on up to threads - 1 helpers. Each call must take pieces until none is left, and
/// must not throw. Returns when all calls that began have ended: a helper that comes too late is not waited for. Within
/// shared work, and while another thread shares its own, this thread does all of it.
void share_work(int threads, void (*call)(const void* body), const void* body);

/// The same for body().
template <class Body>
void share_work(int threads, const Body& body) {
  share_work(
      threads, [](const void* shared) { (*static_cast<const Body*>(shared))(); }, &body);
}

}  // namespace nilas
