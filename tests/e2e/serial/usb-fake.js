// navigator.usb as Chromium has it, with the devices of usb-bus.mjs, for pages and workers; tests put `const FAKE = { bus }`
// before. Names and texts of errors are Chromium's.
/* global FAKE */
{
  let socket;
  let asked = 0;
  const waiting = new Map();
  const devices = new Map();

  async function ask(what) {
    socket ??= new Promise((resolve, reject) => {
      const opened = new WebSocket(FAKE.bus);
      opened.onopen = () => resolve(opened);
      opened.onerror = reject;
      opened.onmessage = ({ data }) => heard(JSON.parse(data));
    });
    const open = await socket;
    const id = ++asked;
    open.send(JSON.stringify({ id, ...what }));
    const { error, ...answer } = await new Promise((resolve) => waiting.set(id, resolve));
    if (error) throw new DOMException(error[1], error[0]);
    return answer;
  }

  function heard({ id, event, ...answer }) {
    if (event) return usb.dispatchEvent(new Event(event));
    waiting.get(id)(answer);
    waiting.delete(id);
  }

  const setup = ({ requestType, recipient, request, value, index }, direction) => {
    const type = direction | ({ standard: 0, class: 1, vendor: 2 }[requestType] << 5) | { device: 0, interface: 1 }[recipient];
    return { type, request, value, index };
  };
  const received = ({ status, data }) => ({ status, data: data && new DataView(Uint8Array.from(data).buffer) });
  const bytes = (data) => data && [...data];

  class FakeDevice {
    opened = false;
    configuration = null;
    #key;

    constructor({ key, interfaces, ...descriptor }) {
      Object.assign(this, descriptor);
      this.#key = key;
      this.configurations = [{ configurationValue: 1, interfaces }];
    }

    #ask(what, rest) {
      return ask({ do: what, key: this.#key, ...rest });
    }

    async open() {
      await this.#ask("open");
      this.opened = true;
    }

    async close() {
      this.opened = false;
      await this.#ask("close");
    }

    async selectConfiguration(value) {
      this.configuration = this.configurations.find(({ configurationValue }) => configurationValue === value);
    }

    claimInterface(number) {
      return this.#ask("claim", { number });
    }

    async controlTransferIn(what, length) {
      return received(await this.#ask("control", { ...setup(what, 0x80), length }));
    }

    async controlTransferOut(what, data) {
      return this.#ask("control", { ...setup(what, 0), data: bytes(data) });
    }

    async transferIn(endpoint, length) {
      return received(await this.#ask("in", { endpoint, length }));
    }

    async transferOut(endpoint, data) {
      return this.#ask("out", { endpoint, data: bytes(data) });
    }

    async clearHalt() {}
  }

  class FakeUsb extends EventTarget {
    async getDevices() {
      const { list } = await ask({ do: "list" });
      for (const one of list) if (!devices.has(one.key)) devices.set(one.key, new FakeDevice(one));
      return list.map(({ key }) => devices.get(key));
    }

    async requestDevice({ filters }) {
      const chosen = (await this.getDevices()).find((device) => filters.some(({ vendorId, productId }) => device.vendorId === vendorId && device.productId === productId));
      if (!chosen) throw new DOMException("Failed to execute 'requestDevice' on 'USB': No device selected.", "NotFoundError");
      return chosen;
    }
  }
  const usb = new FakeUsb();
  Object.defineProperty(navigator, "usb", { value: usb, configurable: true });
  // As on a phone.
  delete (globalThis.Navigator ?? globalThis.WorkerNavigator).prototype.serial;
}
