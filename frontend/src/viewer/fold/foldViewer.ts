/**
 * The folded board in 3D: solids of panels, lit from above, with an orbiting camera.
 *
 * A frame is rendered only after a change. Contents are set through methods; a click on a panel is
 * passed on.
 */

import {
  Box3,
  type BufferGeometry,
  Color,
  DirectionalLight,
  EdgesGeometry,
  Group,
  HemisphereLight,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshLambertMaterial,
  PerspectiveCamera,
  Raycaster,
  Scene,
  Sphere,
  Spherical,
  Vector2,
  Vector3,
  WebGLRenderer,
} from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import type { Matrix } from "../../geometry/fold";
import { type PanelRings, panelGeometry } from "./panelGeometry";

export interface FoldColours {
  readonly outside: string;
  readonly inside: string;
  readonly edge: string;
  readonly line: string;
  readonly bad: string;
  readonly chosen: string;
}

/** Angle between two faces above which their common edge is drawn (°). */
const SHARP = 25;
/** Share of a mark's colour in the colour of a marked panel. */
const MARKED = 0.6;

export class FoldViewer {
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly board = new Group();
  private readonly camera = new PerspectiveCamera(35, 1, 1, 1e5);
  private readonly controls: OrbitControls;
  private readonly watch: ResizeObserver;
  private readonly lines: LineBasicMaterial;
  private readonly plain: MeshLambertMaterial[] = [];
  private readonly bad: MeshLambertMaterial[] = [];
  private readonly chosen: MeshLambertMaterial[] = [];
  private frame = 0;
  private pressed: Vector2 | null = null;

  constructor(
    private readonly host: HTMLElement,
    private readonly canvas: HTMLCanvasElement,
    private readonly colours: FoldColours,
    private readonly onPick: (panel: number | null) => void,
  ) {
    this.renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true });
    this.renderer.setPixelRatio(devicePixelRatio);
    this.lines = new LineBasicMaterial({ color: colours.line });
    this.camera.up.set(0, 0, 1);
    this.camera.position.set(-1, -1.6, 1.2);
    const sun = new DirectionalLight(0xffffff, 1.6);
    sun.position.set(-0.6, -1, 2);
    this.camera.add(sun);
    this.scene.add(new HemisphereLight(0xffffff, 0x8a8a8a, 2.0), this.camera, this.board);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.addEventListener("change", () => this.draw());
    canvas.addEventListener("pointerdown", this.press);
    canvas.addEventListener("pointerup", this.release);
    this.watch = new ResizeObserver(() => this.resize());
    this.watch.observe(host);
    this.resize();
  }

  /** Show panels; `outsideUp`: the top face is the outside of the carton. */
  show(panels: readonly PanelRings[], caliper: number, outsideUp: boolean): void {
    this.clear();
    const { inside, outside, edge, bad, chosen } = this.colours;
    const faces = [outsideUp ? inside : outside, outsideUp ? outside : inside, edge];
    const dressed = (mark: string | null) =>
      faces.map((face) => {
        // The edges hide no line that lies on them.
        const one = new MeshLambertMaterial({
          color: face,
          polygonOffset: true,
          polygonOffsetFactor: 1,
          polygonOffsetUnits: 1,
        });
        if (mark !== null) one.color.lerp(new Color(mark), MARKED);
        return one;
      });
    this.plain.push(...dressed(null));
    this.bad.push(...dressed(bad));
    this.chosen.push(...dressed(chosen));
    for (const panel of panels) {
      const geometry = panelGeometry(panel, caliper);
      const mesh = new Mesh<BufferGeometry, MeshLambertMaterial[]>(geometry, this.plain);
      mesh.matrixAutoUpdate = false;
      mesh.add(new LineSegments(new EdgesGeometry(geometry, SHARP), this.lines));
      this.board.add(mesh);
    }
    this.draw();
  }

  /** Move the panels to their places. */
  place(transforms: readonly Matrix[]): void {
    this.board.children.forEach((mesh, k) => {
      const matrix = transforms[k];
      if (matrix === undefined) return;
      mesh.matrix.fromArray([...matrix]).transpose();
      mesh.matrixWorldNeedsUpdate = true;
    });
    this.draw();
  }

  /** Colour the panels with faults, and the chosen ones; both by index. */
  mark(bad: ReadonlySet<number>, chosen: ReadonlySet<number>): void {
    this.board.children.forEach((child, k) => {
      const mesh = child as Mesh<BufferGeometry, MeshLambertMaterial[]>;
      mesh.material = chosen.has(k) ? this.chosen : bad.has(k) ? this.bad : this.plain;
    });
    this.draw();
  }

  /** Move the camera so that all panels are visible, in its present direction. */
  fit(): void {
    this.board.updateMatrixWorld(true);
    const ball = new Box3().setFromObject(this.board).getBoundingSphere(new Sphere());
    if (!(ball.radius > 0)) return;
    const narrow = Math.min(1, this.camera.aspect);
    const away = ball.radius / Math.sin((this.camera.fov * Math.PI) / 360) / narrow;
    const way = this.camera.position.clone().sub(this.controls.target).normalize();
    this.controls.target.copy(ball.center);
    this.camera.position.copy(ball.center).addScaledVector(way, 1.05 * away);
    this.camera.near = away / 100;
    this.camera.far = away * 20;
    this.camera.updateProjectionMatrix();
    this.controls.update();
    this.draw();
  }

  /** Turn the camera about the board (radians). */
  orbit(sideways: number, upwards: number): void {
    const offset = this.camera.position.clone().sub(this.controls.target);
    // Spherical has Y upwards.
    const ball = new Spherical().setFromCartesianCoords(offset.x, offset.z, -offset.y);
    ball.theta += sideways;
    ball.phi -= upwards;
    ball.makeSafe();
    const turned = new Vector3().setFromSpherical(ball);
    offset.set(turned.x, -turned.z, turned.y);
    this.camera.position.copy(this.controls.target).add(offset);
    this.controls.update();
    this.draw();
  }

  /** Multiply the distance of the camera. */
  zoom(factor: number): void {
    const offset = this.camera.position.clone().sub(this.controls.target);
    this.camera.position.copy(this.controls.target).addScaledVector(offset, factor);
    this.controls.update();
    this.draw();
  }

  /** The picture on the canvas as a PNG file with a transparent background. */
  picture(): Promise<Blob | null> {
    // In the same task: the browser clears the drawing buffer afterwards.
    this.renderer.render(this.scene, this.camera);
    return new Promise((done) => this.canvas.toBlob(done, "image/png"));
  }

  dispose(): void {
    cancelAnimationFrame(this.frame);
    this.watch.disconnect();
    this.canvas.removeEventListener("pointerdown", this.press);
    this.canvas.removeEventListener("pointerup", this.release);
    this.controls.dispose();
    this.clear();
    this.lines.dispose();
    this.renderer.dispose();
  }

  private clear(): void {
    for (const child of this.board.children) {
      const mesh = child as Mesh<BufferGeometry, MeshLambertMaterial[]>;
      mesh.geometry.dispose();
      for (const lines of mesh.children) (lines as LineSegments).geometry.dispose();
    }
    this.board.clear();
    for (const materials of [this.plain, this.bad, this.chosen])
      for (const one of materials.splice(0)) one.dispose();
  }

  private readonly press = ({ clientX, clientY }: PointerEvent): void => {
    this.pressed = new Vector2(clientX, clientY);
  };

  private readonly release = ({ clientX, clientY }: PointerEvent): void => {
    const moved =
      this.pressed?.distanceTo(new Vector2(clientX, clientY)) ?? Number.POSITIVE_INFINITY;
    if (moved > 4) return;
    const box = this.canvas.getBoundingClientRect();
    const at = new Vector2(
      (2 * (clientX - box.left)) / box.width - 1,
      1 - (2 * (clientY - box.top)) / box.height,
    );
    const ray = new Raycaster();
    ray.setFromCamera(at, this.camera);
    const [hit] = ray.intersectObjects(this.board.children, false);
    this.onPick(hit === undefined ? null : this.board.children.indexOf(hit.object));
  };

  private resize(): void {
    const { clientWidth, clientHeight } = this.host;
    if (clientWidth === 0 || clientHeight === 0) return;
    this.renderer.setSize(clientWidth, clientHeight, false);
    this.camera.aspect = clientWidth / clientHeight;
    this.camera.updateProjectionMatrix();
    this.draw();
  }

  private draw(): void {
    cancelAnimationFrame(this.frame);
    this.frame = requestAnimationFrame(() => this.renderer.render(this.scene, this.camera));
  }
}
