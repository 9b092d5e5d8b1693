// The line to the session: it comes back by itself after a loss, with the set-up that stood there.
import { VERSION } from "./messages";
import type { ClientMessage, ServerMessage } from "./messages";
import { isLink } from "./link";
import { session } from "./remember";
import { store } from "./store";
import { told } from "./texts";

export type State = "connecting" | "connected" | "lost" | "refused" | "replaying";

interface Credentials {
  token: string;
  name: string;
}

export class Line {
  private socket: WebSocket | null = null;
  private wait = 250;
  private closed = false;
  private first = true;

  constructor(
    private credentials: Credentials,
    private say: (state: State, reason?: () => string) => void,
  ) {
    store.send = (message) => this.send(message);
    this.open();
  }

  private send(message: ClientMessage): void {
    store.note(message, store.snapshot?.t ?? 0);
    if (this.socket?.readyState === WebSocket.OPEN) this.socket.send(JSON.stringify(message));
  }

  private open(): void {
    this.say(this.first ? "connecting" : "lost");
    const address = new URL("ws", document.baseURI);
    address.protocol = address.protocol.replace("http", "ws");
    address.hash = "";
    const socket = new WebSocket(address);
    this.socket = socket;
    socket.onopen = () => this.greet();
    socket.onmessage = (event) => this.hear(JSON.parse(event.data as string) as ServerMessage);
    socket.onclose = () => this.lost();
  }

  private greet(): void {
    const linked = this.first && isLink(location.hash); // begins a session of its own
    this.send({
      kind: "Hello", version: VERSION, session: linked ? "" : (session.getItem("session") ?? ""),
      token: this.credentials.token, name: this.credentials.name, setup: store.changed ? store.setup : null,
    });
  }

  private hear(message: ServerMessage): void {
    if (message.kind === "Snapshot") this.send({ kind: "Ack", n: message.n });
    if (message.kind === "Welcome") {
      session.setItem("session", message.session);
      this.wait = 250;
      this.first = false;
      this.say("connected");
    }
    if (message.kind === "Refused") {
      this.closed = true;
      this.say("refused", () => told(message.parts));
    }
    store.hear(message);
  }

  private lost(): void {
    if (this.closed) return;
    this.say("lost");
    window.setTimeout(() => this.open(), this.wait);
    this.wait = Math.min(this.wait * 1.6, 3000);
  }
}
