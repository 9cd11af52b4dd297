import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * What every adapter in Java does: {@code serve} reads case lines from stdin, writes the declaration
 * and then an answer a line to stdout. src/external/README.md has all that may be declared.
 */
final class Protocol {
  /** Called for each case; what it throws ends the program, and the case is counted as crashed. */
  interface Collider {
    Answer collide(Body a, Body b);
  }

  /** It cannot take this case. */
  static final class Unsupported extends RuntimeException {
    Unsupported(String why) {
      super(why);
    }
  }

  /**
   * A shape and its pose, as stored: all are floats. 1 vertex is a circle, 2 are a segment or, with a
   * radius, a capsule, more a polygon, counter-clockwise and strictly convex. Vertex v stands at
   * (c x - s y + p.x, s x + c y + p.y) in the world; (c, s) is a unit vector to a float's bits only.
   */
  record Body(float[][] vertices, float radius, boolean round, float[] position, float[] rotation) {
    int count() {
      return vertices.length;
    }

    /** An engine that computes in double takes the transpose of a rotation for its inverse: it gets
     * cos / length and sin / length, and lengths in the body's frame are multiplied by this. */
    double length() {
      return Math.sqrt((double) rotation[0] * rotation[0] + (double) rotation[1] * rotation[1]);
    }

    /** Of the face from vertex i to the next: outward, of length 1. */
    double[] normal(int i) {
      float[] next = vertices[(i + 1) % count()];
      double x = (double) next[0] - vertices[i][0];
      double y = (double) next[1] - vertices[i][1];
      double length = Math.sqrt(x * x + y * y);
      return new double[] {y / length, -x / length};
    }

    /** The place in the world of a point of the body's frame. */
    double[] toWorld(double x, double y) {
      return new double[] {rotation[0] * x - rotation[1] * y + position[0],
        rotation[1] * x + rotation[0] * y + position[1]};
    }
  }

  /** Points in the world, each with the overlap there; without points there is no contact. */
  static final class Answer {
    private final List<String> points = new ArrayList<>();
    private String rest = "";

    void add(double x, double y, double depth) {
      points.add("{\"position\": [" + x + ", " + y + "], \"depth\": " + depth + "}");
    }

    /** Unit, from A to B unless "b_to_a" is declared. */
    void setNormal(double x, double y) {
      rest += ", \"normal\": [" + x + ", " + y + "]";
    }

    /** Whose face clips: "a" or "b". */
    void setReference(String side) {
      rest += ", \"reference\": \"" + side + "\"";
    }

    @Override
    public String toString() {
      return "{\"points\": [" + String.join(", ", points) + "]" + (points.isEmpty() ? "" : rest) + "}";
    }
  }

  /** As Maven names the jar that has the class: name-version.jar. */
  static String versionOf(Class<?> ofEngine) {
    String jar = ofEngine.getProtectionDomain().getCodeSource().getLocation().getPath();
    return jar.replaceFirst(".*-([0-9][^/]*)\\.jar$", "$1");
  }

  /** {@code declaration} is JSON, {@code snippet} a program that shows one case. */
  static void serve(String declaration, String snippet, Collider collider) throws IOException {
    BufferedReader lines = new BufferedReader(new InputStreamReader(System.in));
    // Where the engine throws, the answers before it still go out: they tell which case.
    try (PrintWriter answers = new PrintWriter(System.out)) {
      String declared = declaration.strip().replace("\n", " "); // one line
      answers.println("{\"declaration\": " + declared.substring(0, declared.length() - 1)
          + ", \"snippet\": " + quoted(snippet) + "}}");
      answers.flush();
      for (String line; (line = lines.readLine()) != null; ) {
        if (line.isBlank()) continue;
        answers.println(answer(line, collider));
        if (!lines.ready()) answers.flush();
      }
    }
  }

  private static String answer(String line, Collider collider) {
    try {
      Matcher bodies = BODY.matcher(line);
      return collider.collide(read(bodies), read(bodies)).toString();
    } catch (Unsupported cannot) {
      return "{\"unsupported\": " + quoted(cannot.getMessage()) + "}";
    }
  }

  // A body as manifuzz writes it: these keys, in this order, and its normals, which engines compute.
  private static final Pattern BODY = Pattern.compile("\"vertices\": \\[(.*?)\\], \"radius\": (.*?), "
      + "(?:\"rounding\": \"(.*?)\", )?\"position\": (.*?), \"rotation\": (\\[.*?\\]), \"normals\"");

  private static Body read(Matcher matcher) {
    if (!matcher.find()) throw new IllegalArgumentException("a body is missing");
    float[] numbers = floats(matcher.group(1));
    float[][] vertices = new float[numbers.length / 2][];
    for (int i = 0; i < vertices.length; ++i) {
      vertices[i] = new float[] {numbers[2 * i], numbers[2 * i + 1]};
    }
    boolean round = vertices.length < 3 || "round".equals(matcher.group(3));
    return new Body(vertices, floats(matcher.group(2))[0], round, floats(matcher.group(4)),
        floats(matcher.group(5)));
  }

  // Every number of a case is a float; its line has all digits of it.
  private static float[] floats(String text) {
    String[] numbers = text.replaceAll("[\\[\\] ]", "").split(",");
    float[] all = new float[numbers.length];
    for (int i = 0; i < all.length; ++i) all[i] = Float.parseFloat(numbers[i]);
    return all;
  }

  private static String quoted(String text) {
    return "\"" + text.replace("\\", "\\\\").replace("\"", "\\\"").replace("\n", "\\n")
        .replaceAll("\\p{Cntrl}", " ") + "\"";
  }

  private Protocol() {}
}
