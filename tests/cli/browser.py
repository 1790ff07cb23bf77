"""Chromium, driven through chromium-driver: WebDriver's JSON (W3C WebDriver, section 5) and what Chromium adds to it."""

import base64
import json
import re
import subprocess
import urllib.error
import urllib.request

PROGRAMS = ('chromium', 'chromedriver')
ELEMENT = 'element-6066-11e4-a52e-4f735466cecf' # the key of an element's id, section 12
KEYS = {name: chr(code) for name, code in (
    ('Left', 0xE012), ('Up', 0xE013), ('Right', 0xE014), ('Down', 0xE015), ('PageUp', 0xE00E), ('PageDown', 0xE00F),
    ('End', 0xE010), ('Home', 0xE011), ('Shift', 0xE008), ('Enter', 0xE007), ('Escape', 0xE00C), ('Tab', 0xE004))}


class Browser:
    """One window with a profile of its own in `directory`. Narrow is a phone's, with touch."""

    def __init__(self, directory, width=1280, height=900, phone=False):
        home = directory / 'home'
        home.mkdir()
        environment = {'HOME': str(home), 'PATH': '/usr/bin:/bin', 'LC_ALL': 'C.UTF-8'}
        self.driver = subprocess.Popen(['chromedriver', '--port=0'], env=environment, stdin=subprocess.DEVNULL,
                                       stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        try:
            port = next(found[1] for found in map(re.compile(r'successfully on port (\d+)').search, self.driver.stdout) if found)
            self.address = f'http://127.0.0.1:{port}/session'
            self.address += '/' + self.call('POST', '', {'capabilities': {'alwaysMatch': self.wishes(
                directory / 'profile', width, height, phone)}})['sessionId']
            self.open('about:blank') # away from Chromium's own first page
        except BaseException:
            self.end_driver()
            raise

    @staticmethod
    def wishes(profile, width, height, phone):
        options = {'args': [
            '--headless', '--no-sandbox', '--disable-gpu', '--disable-dev-shm-usage', '--disable-quic', '--no-first-run',
            '--disable-background-networking', '--disable-component-update', '--disable-sync', '--hide-scrollbars',
            '--force-device-scale-factor=1', f'--window-size={width},{height}', f'--user-data-dir={profile}']}
        if phone:
            options['mobileEmulation'] = {'deviceMetrics': {'width': width, 'height': height, 'pixelRatio': 1, 'touch': True}}
        return {'goog:chromeOptions': options, 'goog:loggingPrefs': {'performance': 'ALL', 'browser': 'ALL'}}

    def close(self):
        try:
            self.call('DELETE', '')
        finally:
            self.end_driver()

    def end_driver(self):
        self.driver.terminate()
        self.driver.wait()
        self.driver.stdout.close()

    def call(self, method, path, body=None):
        data = None if body is None else json.dumps(body).encode()
        request = urllib.request.Request(self.address + path, data, {'Content-Type': 'application/json'}, method=method)
        opener = urllib.request.build_opener(urllib.request.ProxyHandler({}))
        try:
            with opener.open(request, timeout=60) as answer:
                return json.load(answer)['value']
        except urllib.error.HTTPError as error:
            raise AssertionError(json.load(error)['value']['message']) from error

    # ---- what is asked of it ----

    def open(self, address):
        self.call('POST', '/url', {'url': address})

    def run(self, script, *arguments):
        """The value of a script's `return`, or of the promise that it returns."""
        return self.call('POST', '/execute/sync', {'script': script, 'args': list(arguments)})

    def find(self, selector):
        return self.call('POST', '/element', {'using': 'css selector', 'value': selector})[ELEMENT]

    def role(self, selector):
        """The role and the name that assistive technology is told."""
        element = self.find(selector)
        return tuple(self.call('GET', f'/element/{element}/computed{what}') for what in ('role', 'label'))

    def click(self, selector):
        self.call('POST', f'/element/{self.find(selector)}/click', {})

    def type(self, selector, *keys):
        """Text, and names of keys."""
        text = ''.join(KEYS.get(key, key) for key in keys)
        self.call('POST', f'/element/{self.find(selector)}/value', {'text': text})

    def press(self, *keys):
        """Names of keys, or characters, one after the other, where the focus is."""
        codes = [KEYS.get(key, key) for key in keys]
        strokes = [{'type': kind, 'value': code} for code in codes for kind in ('keyDown', 'keyUp')]
        self.call('POST', '/actions', {'actions': [{'type': 'key', 'id': 'keys', 'actions': strokes}]})

    def drag(self, start, end, pointer='mouse'):
        """From one place in the window to another, with a mouse or a finger."""
        moves = [dict(zip('xy', place), type='pointerMove', duration=duration) for place, duration in ((start, 0), (end, 100))]
        actions = [moves[0], {'type': 'pointerDown', 'button': 0}, moves[1], {'type': 'pointerUp', 'button': 0}]
        self.call('POST', '/actions', {'actions': [{
            'type': 'pointer', 'id': pointer, 'parameters': {'pointerType': pointer}, 'actions': actions}]})

    def prefer(self, **features):
        """Media features such as prefers_color_scheme='dark'."""
        wanted = [{'name': name.replace('_', '-'), 'value': value} for name, value in features.items()]
        self.devtools('Emulation.setEmulatedMedia', features=wanted)

    def devtools(self, command, **parameters):
        return self.call('POST', '/goog/cdp/execute', {'cmd': command, 'params': parameters})

    def screenshot(self, selector=None):
        """A PNG of the window, or of an element."""
        path = f'/element/{self.find(selector)}/screenshot' if selector else '/screenshot'
        return base64.b64decode(self.call('GET', path))

    def console(self):
        """Messages since the last time, of any level."""
        return self.call('POST', '/se/log', {'type': 'browser'})

    def requests(self):
        """Addresses that the page has asked for since the last time."""
        messages = [json.loads(entry['message'])['message'] for entry in self.call('POST', '/se/log', {'type': 'performance'})]
        return [message['params']['request']['url'] for message in messages if message['method'] == 'Network.requestWillBeSent']
