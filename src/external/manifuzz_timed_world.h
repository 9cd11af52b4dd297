/* An engine's world in a shared library, whose time `manifuzz scene` has beside its own: define
   these five functions, beside a collider's two or alone, and name the world among the
   "timed_worlds" of the engine's engine.json. */
#ifndef MANIFUZZ_TIMED_WORLD_H
#define MANIFUZZ_TIMED_WORLD_H

#include "manifuzz_collider.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Yours. */
typedef struct manifuzz_timed_world manifuzz_timed_world;

/* A body's new place. */
typedef struct {
  uint32_t body; /* 0 is the first that was added */
  manifuzz_float2 position;
  manifuzz_float2 rotation; /* (cos, sin) */
} manifuzz_move;

/* An empty world of that name, as engine.json has it, or NULL: there is none such. */
manifuzz_timed_world* manifuzz_timed_world_create(const char* name);

/* Adds a body, which nothing but `manifuzz_timed_world_step` is to move. Returns 0, or 1 for one
   that it cannot take. */
int manifuzz_timed_world_add(manifuzz_timed_world* world, const manifuzz_body* body);

/* One step, at whose end these bodies are where `moves` has them, and all others rest; `moves` may
   be NULL where `count` is 0. Gives the nanoseconds that the engine's own clock says its work on
   contacts took, on one thread: on those of where bodies were or of where they are. */
double manifuzz_timed_world_step(manifuzz_timed_world* world, const manifuzz_move* moves,
                                 int32_t count);

/* The number of pairs that touch where the last moves left the bodies, a gap not counted that the
   engine has contacts for. It may take a step. */
int64_t manifuzz_timed_world_contacts(manifuzz_timed_world* world);

void manifuzz_timed_world_destroy(manifuzz_timed_world* world);

#ifdef __cplusplus
}
#endif
#endif
